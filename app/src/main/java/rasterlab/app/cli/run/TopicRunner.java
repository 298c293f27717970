package rasterlab.app.cli.run;

import java.time.Duration;
import java.util.List;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Written;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.StrictJson;

/** Runs the methods of any topic on JSON, as the topic's format says. */
public final class TopicRunner<C> {
    private static final Duration LONGEST = Duration.ofSeconds(60);

    private final Watch watch;
    private final Topic<C, ?, ?> topic;
    private final Format<C, ?, ?> format;

    /**
     * The topic of that name.
     *
     * @throws Complaint listing the topics, if there is none
     */
    public static TopicRunner<?> named(String topic) {
        try {
            return of(Topics.named(topic));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private static <C> TopicRunner<C> of(Topic<C, ?, ?> topic) {
        return new TopicRunner<>(new Watch(LONGEST), topic, topic.format());
    }

    /**
     * @param watch gives up a method that does not end
     */
    TopicRunner(Watch watch, Topic<C, ?, ?> topic, Format<C, ?, ?> format) {
        this.watch = watch;
        this.topic = topic;
        this.format = format;
    }

    public Format<C, ?, ?> format() {
        return format;
    }

    /**
     * Passes if the topic has that method.
     *
     * @throws Complaint listing the methods, if it has not
     */
    public void requireMethod(String method) {
        try {
            topic.method(method);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    /**
     * Reads one input and runs a method on it.
     *
     * @param method one of the topic's methods
     * @param text JSON in UTF-8, of which the first {@code length} bytes count
     * @param steps whether the answer has the recorded walk too
     * @return the fields of a JSON object
     * @throws Complaint if the text is not an input of the topic, or the method refuses it, crashes
     *     or does not end
     */
    public Written answer(String method, byte[] text, int length, boolean steps) {
        try {
            return answered(method, text, length, steps);
        } catch (InvalidInput invalid) {
            throw Complaint.badInput(invalid.getMessage());
        }
    }

    private Written answered(String method, byte[] text, int length, boolean steps) {
        Call<C> call = call(method, steps);
        Given given = StrictJson.read(text, length, format.input(), format.open());
        return watch.call(method, format.prepared(call, given));
    }

    private Call<C> call(String method, boolean steps) {
        var call = new Call<>(method, topic.method(method).implementation(), steps);
        if (steps && !format.hasSteps()) throw call.noSteps();
        return call;
    }

    /**
     * Runs a method on the input of a hazard.
     *
     * @param method one of the topic's methods
     * @param steps whether the answers have the recorded walk too
     * @return the fields of a JSON object for each input that {@link #answer} would take, mostly
     *     one
     * @throws Complaint listing the topic's hazards if there is none of that name, or if the method
     *     refuses the input, crashes or does not end
     */
    public List<Written> answerHazard(String method, String hazard, boolean steps) {
        try {
            return answers(format, call(method, steps), hazard);
        } catch (InvalidInput invalid) {
            throw Complaint.badInput(invalid.getMessage());
        }
    }

    private <I> List<Written> answers(Format<C, I, ?> format, Call<C> call, String hazard) {
        return format.singles(input(format.topic(), hazard)).stream()
                .map(single -> watch.call(call.name(), format.prepared(call, single)))
                .toList();
    }

    private static <I> I input(Topic<?, I, ?> topic, String hazard) {
        String kind = topic.name() + " hazard";
        try {
            return Named.find(kind, hazard, topic.hazards(), Hazard::name).input();
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }
}
