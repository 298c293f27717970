package rasterlab.engine.color;

import java.util.List;
import rasterlab.contract.ColorConverter;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class ColorMethods {
    private static final String CHAPTER =
            "Kazantsev, course text on computer graphics, chapter 7, the RGB cube";
    private static final String SMITH =
            "A. R. Smith, Color gamut transform pairs, SIGGRAPH 1978; " + CHAPTER;

    private ColorMethods() {}

    static List<Method<ColorConverter>> all() {
        return List.of(
                new Method<>(
                        "formula-textbook",
                        new About(
                                "cmy = 1 − rgb; k = min(c, m, y), c' = (c − k)/(1 − k);"
                                        + " s = √(r² + g² + b² − v²) from the grey diagonal",
                                "none; greys and black are not told apart from other colours",
                                "about 30 operations, 2 square roots and 1 arctangent",
                                "grey has a hue, black is divided 0 by 0, half the digits of a"
                                        + " small saturation are lost, nothing is out of range",
                                CHAPTER),
                        new CarelessColors()),
                new Method<>(
                        "eight-bit",
                        new About(
                                "the formulas, every number rounded to 1/255, hues to 1/256 turn",
                                "each number fits a byte",
                                "as the formulas, and a rounding for each number",
                                "rounding, by which many colours do not come back from a hue in a byte",
                                SMITH),
                        new ByteColors()),
                new Method<>(
                        "formula",
                        new About(
                                "c' = (max − r)/max; hsv: v = max, s = (max − min)/max, h in"
                                        + " sixths of a turn; hvs: v = (r + g + b)/√3, s ="
                                        + " √(((r − g)² + (g − b)² + (b − r)²)/3)",
                                "saturation 0 and no hue go together",
                                "about 40 operations, 1 square root and 1 arctangent",
                                "none known; refuses what is out of range, and a value of hsv, a"
                                        + " value or a saturation of hvs between 0 and 10⁻³⁰⁰",
                                SMITH),
                        new FormulaColors()));
    }
}
