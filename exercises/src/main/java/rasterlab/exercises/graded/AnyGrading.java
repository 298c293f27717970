package rasterlab.exercises.graded;

import java.util.List;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.judging.ByTopic;
import rasterlab.exercises.score.CasePicture;

/**
 * Grades any topic whose contract a child can be called by. Its answers are drawn by their form,
 * and a student's speed is held against the exercise's model solution.
 */
public final class AnyGrading<C, I, O> extends ByTopic<C, I, O> {
    private AnyGrading(Topic<C, I, O> topic, Class<C> contract) {
        super(topic, contract);
    }

    /**
     * The grading of a topic.
     *
     * @param contract of the topic
     */
    @SuppressWarnings("unchecked") // the methods of a topic implement its contract
    public static <C, I, O> AnyGrading<C, I, O> of(Topic<C, I, O> topic, Class<?> contract) {
        return new AnyGrading<>(topic, (Class<C>) contract);
    }

    @Override
    protected List<CasePicture> pictures(I input, O exact, O actual) {
        return new FormPictures(json(input), json(input, exact), json(input, actual)).drawn();
    }
}
