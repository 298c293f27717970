package rasterlab.engine.signmap;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Topic;

/** A predicate with the methods that answer it. */
public interface SignSubject {
    /** Name of the topic, or of the predicate where no topic has it. */
    String name();

    /** Names of the methods, in teaching order. */
    List<String> methods();

    /**
     * The answers of that method.
     *
     * @throws IllegalArgumentException if there is none of that name; lists those there are
     */
    SignMap map(String method);

    /**
     * The points that stay where they are, as they are written on paper; empty where an input of
     * the topic tells them.
     */
    Optional<String> others();

    /** The topic's, if it asks such a question. */
    static <C, I, O> Optional<SignSubject> of(Topic<C, I, O> topic) {
        return topic.question().map(question -> new TopicSigns<>(topic, question));
    }

    /** The predicates of geometry that stand behind many topics and are none. */
    static List<SignSubject> basic() {
        return List.of(OrientationForms.subject(), PlaneSideForms.subject());
    }

    /**
     * The predicate of that name among some.
     *
     * @throws IllegalArgumentException if there is none; lists those there are
     */
    static SignSubject find(String name, List<SignSubject> all) {
        return Named.find("predicate", name, all, SignSubject::name);
    }
}
