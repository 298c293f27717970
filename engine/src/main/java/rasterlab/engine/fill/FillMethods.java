package rasterlab.engine.fill;

import java.util.List;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that fill a region, in teaching order. */
final class FillMethods {
    private static final String SMITH = "A. R. Smith, Tint fill, SIGGRAPH, 1979";

    private FillMethods() {}

    static List<Method<SeedFiller>> all() {
        return List.of(recursiveTextbook(), stack(), span());
    }

    private static Method<SeedFiller> recursiveTextbook() {
        return new Method<>(
                "recursive-textbook",
                new About(
                        "fill the run; call itself for the runs of the next row that touch it, and"
                                + " for those of the row before beyond the ends of the run there",
                        "none; the loop back beyond the right end stops one column early",
                        "one call and about three reads per pixel of a run",
                        "overflows the call stack on long regions; endless around a hole when the"
                                + " colours are equal; leaves out what lies behind the last column;"
                                + " knows no diagonals",
                        "V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. 75"),
                new RecursiveTextbookFill());
    }

    private static Method<SeedFiller> stack() {
        return new Method<>(
                "stack",
                new About(
                        "take a pixel off the stack; write its neighbours of the old colour and put"
                                + " them on the stack",
                        "every pixel on the stack is written, and all its neighbours will be read",
                        "one write, 4 or 8 reads and one push per pixel",
                        "none known; memory for up to all pixels of the region",
                        SMITH),
                new StackFill());
    }

    private static Method<SeedFiller> span() {
        return new Method<>(
                "span",
                new About(
                        "take a piece of a row off the stack; fill the run around its first pixel of"
                                + " the old colour; put the pieces above and below on the stack",
                        "what touches a filled run is filled or waits on the stack",
                        "one write and three to four reads per pixel, up to three pushes per run",
                        "none known",
                        SMITH),
                new SpanFill());
    }
}
