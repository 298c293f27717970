package rasterlab.engine.study;

import java.lang.reflect.Constructor;
import java.util.List;

/**
 * The list of one topic's mutants: class {@code LineMutants} beside {@code LineTopic}'s tests, with
 * a constructor without parameters, is that of {@code LineTopic}.
 */
public interface Mutants<C> {
    /** Five to ten one-mistake methods, each a likely mistake of somebody who learns the topic. */
    List<Mutant<C>> all();

    /** The list that stands beside the topic's tests. */
    @SuppressWarnings("unchecked") // MutantsTest runs each on its topic and so finds any other
    static <C> Mutants<C> of(Topic<C, ?, ?> topic) {
        String name = topic.getClass().getName().replaceAll("Topic$", "Mutants");
        try {
            Constructor<?> constructor = Class.forName(name).getDeclaredConstructor();
            constructor.setAccessible(true);
            return (Mutants<C>) constructor.newInstance();
        } catch (ReflectiveOperationException e) {
            throw new AssertionError("topic '" + topic.name() + "' needs its " + name, e);
        }
    }
}
