package rasterlab.exercises.graded;

import java.util.Optional;
import rasterlab.engine.color.ColorSheet;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.drawing.ColorSwatches;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PictureBytes;

/** Draws any topic's answers by their form, where nothing is graded. */
public final class AnswerPictures<C, I, O> extends ByForm<C, I, O> {
    public AnswerPictures(Topic<C, I, O> topic) {
        super(topic);
    }

    /**
     * How an answer differs from the right one; empty where nothing can be drawn of it.
     *
     * @param exact the right answer
     * @param actual the same where nothing differs
     */
    public Optional<PictureBytes> drawn(I input, O exact, O actual) {
        if (!isSingle(input)) return several(exact, actual);
        return CasePicture.of(pictures(input, exact, actual), CasePicture.DIFFERENCE)
                .map(CasePicture::file);
    }

    /** The right answer; empty where nothing can be drawn of it. */
    public Optional<PictureBytes> right(I input, O exact) {
        if (!isSingle(input)) return several(exact, exact);
        return Optional.of(
                new RightPicture(topic().format(), json(input), json(input, exact)).drawn());
    }

    private boolean isSingle(I input) {
        return topic().format().singles(input).size() == 1;
    }

    /** Answers to several inputs at once, which colours have. */
    private static Optional<PictureBytes> several(Object exact, Object actual) {
        if (!(exact instanceof ColorSheet right) || !(actual instanceof ColorSheet came))
            return Optional.empty();
        return Optional.of(PictureBytes.alike(new ColorSwatches(right, came).png()));
    }
}
