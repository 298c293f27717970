package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.study.Topic;

/** How one topic's inputs and answers look as JSON. */
public interface TopicRun {
    Topic<?, ?, ?> topic();

    Form form();

    /**
     * What the JSON looks like, for people.
     *
     * @param input the fields of an input, each with what stands for its value
     * @param answer the fields of an answer
     */
    record Form(String input, String answer) {}

    /**
     * Reads one input and runs a method on it.
     *
     * @param method one of the topic's methods
     * @param text JSON in UTF-8, of which the first {@code length} bytes count
     * @param steps whether the answer has the recorded walk too
     * @throws Complaint if the text is not an input of the topic, or the method refuses it, crashes
     *     or does not end
     */
    Answer answer(String method, byte[] text, int length, boolean steps);

    /** A recorded answer. */
    interface Answer {
        /** Writes one JSON object. */
        void write(JsonGenerator json) throws IOException;
    }
}
