package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Misfit;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.StrictJson;

/** Runs the methods of any topic on JSON, as the topic's format says. */
public final class TopicRunner<C> implements TopicRun {
    private final Watch watch;
    private final Topic<C, ?, ?> topic;
    private final Format<C, ?, ?> format;

    /**
     * @param watch gives up a method that does not end
     */
    static <C> TopicRunner<C> of(Watch watch, Topic<C, ?, ?> topic) {
        return new TopicRunner<>(watch, topic, topic.format());
    }

    TopicRunner(Watch watch, Topic<C, ?, ?> topic, Format<C, ?, ?> format) {
        this.watch = watch;
        this.topic = topic;
        this.format = format;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(format.reads(), format.answers());
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        try {
            return new Answered(answered(method, text, length, steps));
        } catch (Misfit misfit) {
            throw Complaint.badInput(misfit.getMessage());
        }
    }

    private Written answered(String method, byte[] text, int length, boolean steps) {
        var call = new Call<>(method, topic.method(method).implementation(), steps);
        if (steps && !format.hasSteps()) throw call.noSteps();
        Given given = StrictJson.read(text, length, format.input(), format.open());
        return watch.call(method, format.prepared(call, given));
    }

    /** An answer as JSON. */
    private record Answered(Written written) implements Answer {
        @Override
        public void write(JsonGenerator json) throws IOException {
            written.write(new JsonSink(json));
        }
    }
}
