package rasterlab.exercises.graded;

import java.util.List;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.judging.ByTopic;
import rasterlab.exercises.score.CasePicture;

/** Grades a topic whose answers are drawn by their form. */
abstract class ByForm<C, I, O> extends ByTopic<C, I, O> {
    ByForm(Topic<C, I, O> topic) {
        super(topic);
    }

    /**
     * @param contract what a student implements, where that is not the topic's
     */
    ByForm(Topic<C, I, O> topic, Class<?> contract) {
        super(topic, contract);
    }

    @Override
    protected final List<CasePicture> pictures(I input, O exact, O actual) {
        var fields = new FormFields(topic().format(), json(input));
        return new FormPictures(fields, json(input, exact), json(input, actual)).drawn();
    }
}
