package rasterlab.app.visibility;

import java.util.Optional;

/**
 * What the lab shows at one moment.
 *
 * @param picture the newest finished picture, maybe of an earlier choice
 * @param other the other method's picture, made with it
 * @param difference from the exact picture of the present choice; empty while it is made or when it
 *     is not asked for
 * @param otherDifference the same of the other method
 * @param drawn the method's steps; empty while they are found, or where they are not asked for
 * @param step how many of them are made
 * @param pixel what happened at the chosen pixel; empty while that is found out
 * @param chosen the chosen pixel
 * @param problem why a file was not opened or saved, "" if nothing went wrong
 * @param medianNanos median time of the last pictures of the present method and size; 0 while there
 *     are too few
 * @param undoable whether there is something to undo
 */
public record VisibilityLabState(
        VisibilityChoice choice,
        Optional<Picture> picture,
        Optional<Picture> other,
        Optional<Compared> difference,
        Optional<Compared> otherDifference,
        Optional<Drawn> drawn,
        int step,
        Optional<PixelReport> pixel,
        Optional<ChosenPixel> chosen,
        String problem,
        long medianNanos,
        boolean undoable) {
    static VisibilityLabState of(VisibilityChoice first) {
        return new VisibilityLabState(
                first,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Frame.ALL,
                Optional.empty(),
                Optional.empty(),
                "",
                0,
                false);
    }

    VisibilityLabState with(VisibilityChoice next) {
        return new VisibilityLabState(
                next,
                picture,
                other,
                Optional.empty(),
                Optional.empty(),
                drawn,
                step,
                Optional.empty(),
                chosen,
                problem,
                medianNanos,
                undoable);
    }

    VisibilityLabState with(Frame.Pictures made) {
        return new VisibilityLabState(
                choice,
                Optional.of(made.first()),
                made.second(),
                difference,
                otherDifference,
                drawn,
                step,
                pixel,
                chosen,
                problem,
                medianNanos,
                undoable);
    }

    VisibilityLabState withDifferences(Compared first, Optional<Compared> second) {
        return new VisibilityLabState(
                choice,
                picture,
                other,
                Optional.of(first),
                second,
                drawn,
                step,
                pixel,
                chosen,
                problem,
                medianNanos,
                undoable);
    }

    VisibilityLabState withDrawn(Optional<Drawn> found) {
        return new VisibilityLabState(
                choice,
                picture,
                other,
                difference,
                otherDifference,
                found,
                step,
                pixel,
                chosen,
                problem,
                medianNanos,
                undoable);
    }

    VisibilityLabState at(int next) {
        return new VisibilityLabState(
                choice,
                picture,
                other,
                difference,
                otherDifference,
                drawn,
                next,
                pixel,
                chosen,
                problem,
                medianNanos,
                undoable);
    }

    VisibilityLabState with(Optional<PixelReport> found) {
        return new VisibilityLabState(
                choice,
                picture,
                other,
                difference,
                otherDifference,
                drawn,
                step,
                found,
                chosen,
                problem,
                medianNanos,
                undoable);
    }

    VisibilityLabState choosing(Optional<ChosenPixel> next) {
        return new VisibilityLabState(
                choice,
                picture,
                other,
                difference,
                otherDifference,
                drawn,
                step,
                Optional.empty(),
                next,
                problem,
                medianNanos,
                undoable);
    }

    VisibilityLabState withProblem(String said) {
        return new VisibilityLabState(
                choice,
                picture,
                other,
                difference,
                otherDifference,
                drawn,
                step,
                pixel,
                chosen,
                said,
                medianNanos,
                undoable);
    }

    VisibilityLabState measured(long nanos, boolean undo) {
        return new VisibilityLabState(
                choice,
                picture,
                other,
                difference,
                otherDifference,
                drawn,
                step,
                pixel,
                chosen,
                problem,
                nanos,
                undo);
    }
}
