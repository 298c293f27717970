package rasterlab.app.visibility;

import java.util.Optional;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.plan.least.PlannedPicture;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;

/**
 * The state that the lab shows at one moment.
 *
 * @param picture the newest finished picture, maybe of an earlier choice
 * @param other the other method's picture, made with it
 * @param differences from the exact picture of the present choice; empty while they are found or
 *     when they are not counted
 * @param drawn the method's steps; empty while they are found, or where they are not asked for
 * @param step how many of them are made
 * @param pixel what happened at the chosen pixel; empty while that is found out
 * @param chosen the chosen pixel
 * @param problem why a file was not opened, "" if nothing went wrong or something was changed since
 * @param note in what the scene is other than the hazard that it was opened for
 * @param medianNanos median time of the last pictures of the present method and size; 0 while there
 *     are too few
 */
public record VisibilityLabState(
        VisibilityChoice choice,
        Optional<Picture> picture,
        Optional<Picture> other,
        Optional<Differences> differences,
        Optional<Drawn> drawn,
        int step,
        Optional<PixelReport> pixel,
        Optional<ChosenPixel> chosen,
        String problem,
        Optional<HazardNote> note,
        long medianNanos) {
    static VisibilityLabState of(VisibilityChoice first) {
        return new VisibilityLabState(
                first,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Frame.ALL,
                Optional.empty(),
                Optional.empty(),
                "",
                Optional.empty(),
                0);
    }

    /** The faults of the picture; empty where they are not known, or the method refuses. */
    public Optional<Compared> difference() {
        return differences.flatMap(found -> found.first().compared());
    }

    /** The faults of the second picture; empty where they are not known, or its method refuses. */
    public Optional<Compared> otherDifference() {
        return otherOutcome().flatMap(Differences.PictureOutcome::compared);
    }

    /** The result of comparing the other method's picture. */
    Optional<Differences.PictureOutcome> otherOutcome() {
        return differences.flatMap(Differences::second);
    }

    /** The least picture of the present choice; empty while it is made, and for a method's. */
    Optional<PlannedPicture> least() {
        return picture.flatMap(Picture::planned)
                .filter(made -> made.camera().equals(choice.camera()))
                .filter(made -> Optional.of(made.plan().tolerance()).equals(choice.tolerance()));
    }

    /** Whether wrong pixels are marked: they are told of pictures that are drawn to the end. */
    boolean marked() {
        return choice.difference() && choice.view() == StageView.COLORS && step == Frame.ALL;
    }

    /** Whether another method's depths are shown, whose steps are not the chosen one's. */
    boolean lent() {
        return picture.flatMap(Picture::lent).isPresent();
    }

    /** Whether the whole picture of a model, drawn to the end, has nothing of it. */
    boolean showsNothing() {
        return choice.view() == StageView.COLORS
                && step == Frame.ALL
                && choice.shown().up().isPresent()
                && picture.filter(drawn -> drawn.refusal().isEmpty())
                        .filter(Picture::isEmpty)
                        .isPresent();
    }

    VisibilityLabState with(VisibilityChoice next) {
        var draft = new Draft(this);
        draft.choice = next;
        if (!next.equals(choice)) {
            draft.problem = "";
            draft.note = Optional.empty();
        }
        draft.differences = Optional.empty();
        draft.pixel = Optional.empty();
        return draft.state();
    }

    VisibilityLabState with(Frame.FramePictures made) {
        var draft = new Draft(this);
        draft.picture = Optional.of(made.first());
        draft.other = made.second();
        return draft.state();
    }

    VisibilityLabState with(Differences found) {
        var draft = new Draft(this);
        draft.differences = Optional.of(found);
        return draft.state();
    }

    VisibilityLabState withDrawn(Optional<Drawn> found) {
        var draft = new Draft(this);
        draft.drawn = found;
        return draft.state();
    }

    VisibilityLabState at(int next) {
        var draft = new Draft(this);
        draft.step = next;
        return draft.state();
    }

    VisibilityLabState with(Optional<PixelReport> found) {
        var draft = new Draft(this);
        draft.pixel = found;
        return draft.state();
    }

    VisibilityLabState choosing(Optional<ChosenPixel> next) {
        var draft = new Draft(this);
        draft.pixel = Optional.empty();
        draft.chosen = next;
        draft.problem = "";
        return draft.state();
    }

    VisibilityLabState withProblem(String said) {
        var draft = new Draft(this);
        draft.problem = said;
        return draft.state();
    }

    VisibilityLabState with(HazardNote said) {
        var draft = new Draft(this);
        draft.note = Optional.of(said);
        return draft.state();
    }

    VisibilityLabState measured(long nanos) {
        var draft = new Draft(this);
        draft.medianNanos = nanos;
        return draft.state();
    }

    /** Parts of a state, to be changed one by one. */
    private static final class Draft {
        private VisibilityChoice choice;
        private Optional<Picture> picture;
        private Optional<Picture> other;
        private Optional<Differences> differences;
        private Optional<Drawn> drawn;
        private int step;
        private Optional<PixelReport> pixel;
        private Optional<ChosenPixel> chosen;
        private String problem;
        private Optional<HazardNote> note;
        private long medianNanos;

        Draft(VisibilityLabState from) {
            choice = from.choice;
            picture = from.picture;
            other = from.other;
            differences = from.differences;
            drawn = from.drawn;
            step = from.step;
            pixel = from.pixel;
            chosen = from.chosen;
            problem = from.problem;
            note = from.note;
            medianNanos = from.medianNanos;
        }

        VisibilityLabState state() {
            return new VisibilityLabState(
                    choice,
                    picture,
                    other,
                    differences,
                    drawn,
                    step,
                    pixel,
                    chosen,
                    problem,
                    note,
                    medianNanos);
        }
    }
}
