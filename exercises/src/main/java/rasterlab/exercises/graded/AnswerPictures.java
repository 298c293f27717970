package rasterlab.exercises.graded;

import java.util.Optional;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.score.CasePicture;

/** Draws any topic's answers by their form, where nothing is graded. */
public final class AnswerPictures<C, I, O> extends ByForm<C, I, O> {
    public AnswerPictures(Topic<C, I, O> topic) {
        super(topic);
    }

    /**
     * How an answer differs from the right one; empty where the input is none that stands outside
     * the engine.
     *
     * @param exact the right answer
     * @param actual the same where nothing differs
     */
    public Optional<CasePicture> drawn(I input, O exact, O actual) {
        if (topic().format().singles(input).size() != 1) return Optional.empty();
        return CasePicture.of(pictures(input, exact, actual), CasePicture.DIFFERENCE);
    }
}
