#pragma once
// Course files include this name. Nothing that traces rays needs a window, so there is nothing to declare.
