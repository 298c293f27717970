package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that draw a segment, in teaching order; each is a {@link SteppedLine}. */
final class LineMethods {
    private LineMethods() {}

    static List<Method<LineRasterizer>> all() {
        return List.of(
                naiveTextbook(),
                naive(),
                floatDda(),
                dda(),
                bresenhamTextbook(),
                bresenham(),
                midpoint(),
                wu());
    }

    private static Method<LineRasterizer> naiveTextbook() {
        return new Method<>(
                "naive-textbook",
                new About(
                        "y = round(k·x + b), k = (y1 − y0)/(x1 − x0), b = y0 − k·x0",
                        "every column from x0 to x1 gets one pixel",
                        "one multiplication, one addition and one rounding per column",
                        "gaps above 45°, nothing to the left, rubbish on verticals and single"
                                + " points, ties to the larger row, overflow from 2³⁰ on, endless"
                                + " up to the largest int",
                        "the course's lecture texts on raster algorithms, first listing"),
                new NaiveTextbookLine());
    }

    private static Method<LineRasterizer> naive() {
        return new Method<>(
                "naive",
                new About(
                        "s + ⌊k·i + ½ − 1/(4·n)⌋ across after i of n steps along, k = ±b/n",
                        "rounding errors stay below 1/(4·n), the distance to the next decision",
                        "one multiplication, one addition and one floor per pixel",
                        "none known up to n = 2²⁴ steps; longer lines are refused",
                        "the definition of the line; error bound in the class's comment"),
                new NaiveLine());
    }

    private static Method<LineRasterizer> floatDda() {
        return new Method<>(
                "dda-float",
                new About(
                        "x ← x + dx/n, y ← y + dy/n, both in floats, both rounded",
                        "after i steps the rounding errors are up to i²·2⁻²⁵ pixels",
                        "two float additions and two roundings per pixel",
                        "leaves its course on long lines and far from the origin; stands still"
                                + " beyond 2²⁴, where not every pixel has a float",
                        "J. D. Foley et al., Computer Graphics: Principles and Practice, 2nd"
                                + " edition, 1990, section 3.2.1"),
                new FloatDdaLine());
    }

    private static Method<LineRasterizer> dda() {
        return new Method<>(
                "dda",
                new About(
                        "f ← f + k, k = b/n; step across and take 1 off where f ≥ ½",
                        "f = k·i − j ∓ 1/(4·n) up to an error below 1/(4·n)",
                        "one floating-point addition and one comparison per pixel, a second"
                                + " addition where the line steps across",
                        "none known up to n = 2²⁴ steps; longer lines are refused",
                        "the digital differential analyser; error bound in the class's comment"),
                new DdaLine());
    }

    private static Method<LineRasterizer> bresenhamTextbook() {
        return new Method<>(
                "bresenham-textbook",
                new About(
                        "d = 2·(i + 1)·b − (2·j + 1)·n; step across when d > 0",
                        "the sign of d tells on which side of the middle the line passes",
                        "one integer addition and one comparison per pixel",
                        "two pixels too many to the left and upward, a single point becomes two"
                                + " pixels, ties depend on the direction, overflow from 2³⁰ on,"
                                + " endless up to the largest int",
                        "the course's lecture text on raster algorithms, full Bresenham listing"),
                new BresenhamTextbookLine());
    }

    private static Method<LineRasterizer> bresenham() {
        return new Method<>(
                "bresenham",
                new About(
                        "d = 2·(i + 1)·b − (2·j + 1)·n − t; step across when d ≥ 0; t = 1 where"
                                + " the coordinate across does not fall, else 0",
                        "2·b − 2·n ≤ d < 2·b at every pixel",
                        "one integer addition and one comparison per pixel",
                        "none known for any int coordinates",
                        "J. E. Bresenham, Algorithm for computer control of a digital plotter,"
                                + " IBM Systems Journal 4(1), 1965"),
                new BresenhamLine());
    }

    private static Method<LineRasterizer> midpoint() {
        return new Method<>(
                "midpoint",
                new About(
                        "F(M) = 2·b·(u + 1) − n·(2·v + 1), M midway between the two candidates;"
                                + " step across when F(M) > 0",
                        "the sign of F(M) tells on which side of M the line passes",
                        "one integer addition, a second where the line steps across, and one"
                                + " comparison per pixel",
                        "none known for any int coordinates",
                        "M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a"
                                + " digital plotter, Computer Journal 10(3), 1967"),
                new MidpointLine());
    }

    private static Method<LineRasterizer> wu() {
        return new Method<>(
                "wu",
                new About(
                        "coverage 1 − |f| for the nearest pixel, |f| for its neighbour on the"
                                + " line's side",
                        "the two coverages of a step add up to 1",
                        "dda's step, one multiplication and one rounding per pair of pixels",
                        "none known up to n = 2²⁴ steps; longer lines are refused",
                        "X. Wu, An efficient antialiasing technique, Computer Graphics 25(4),"
                                + " 1991"),
                new WuLine());
    }
}
