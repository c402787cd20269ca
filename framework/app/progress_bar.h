#pragma once

namespace app {

// Draws a bar for a fraction in [0, 1] on the terminal, in place of the one before; nothing where stderr is no
// terminal.
void drawProgressBar(float fraction);
void clearProgressBar();

}
