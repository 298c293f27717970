package rasterlab.engine.scene.catalogue;

import java.util.List;

/** Two signs of 5×7 dots, each dot 4×4 texels, in the middle of a square of 64×64 texels. */
final class Glyphs {
    private static final int DOT = 4;
    private static final int COLUMNS = 5;
    private static final int ROWS = 7;
    private static final int LEFT = 10;
    private static final int BOTTOM = 18;

    /** Rows from the top. */
    private static final List<String> LETTERS =
            List.of(
                    ".###. #...# #...# ##### #...# #...# #...#",
                    "####. #...# #...# ####. #...# #...# ####.",
                    ".###. #...# #.... #.... #.... #...# .###.",
                    "####. #...# #...# #...# #...# #...# ####.");

    private static final List<String> DIGITS =
            List.of(
                    "..#.. .##.. ..#.. ..#.. ..#.. ..#.. .###.",
                    ".###. #...# ....# ...#. ..#.. .#... #####",
                    ".###. #...# ....# ..##. ....# #...# .###.",
                    "...#. ..##. .#.#. #..#. ##### ...#. ...#.");

    private Glyphs() {}

    /**
     * @param column 0 to 3, A to D
     * @param row 0 to 3, 1 to 4
     * @param x texels from the square's left side
     * @param y texels from its lower side
     */
    static boolean inked(int column, int row, int x, int y) {
        int dotX = Math.floorDiv(x - LEFT, DOT);
        int dotY = Math.floorDiv(y - BOTTOM, DOT);
        return dot(LETTERS.get(column), dotX, dotY)
                || dot(DIGITS.get(row), dotX - COLUMNS - 1, dotY);
    }

    private static boolean dot(String glyph, int x, int y) {
        return x >= 0
                && x < COLUMNS
                && y >= 0
                && y < ROWS
                && glyph.charAt((ROWS - 1 - y) * (COLUMNS + 1) + x) == '#';
    }
}
