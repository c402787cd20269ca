#pragma once
// Course files include this name. A submission never runs in the window's process, so there is nothing to declare.
