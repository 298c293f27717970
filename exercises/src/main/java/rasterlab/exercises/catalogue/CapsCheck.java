package rasterlab.exercises.catalogue;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.OptionalInt;
import java.util.function.ToLongFunction;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.ContractCall;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.HeldArrays;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Holds the limits that an exercise states against the right answers of its own cases, which must
 * not be stopped. An exercise that states none costs nothing; nor does one that was taken before.
 */
final class CapsCheck {
    private final ExerciseFolder folder;
    private final Exercise exercise;
    private final TopicGrading topic;
    private final ContractCalls contract;

    CapsCheck(ExerciseFolder folder, Exercise exercise) {
        this.folder = folder;
        this.exercise = exercise;
        this.topic = TopicGradings.of(exercise);
        this.contract = ContractCalls.of(topic.contract());
    }

    /**
     * Passes if no case has a longer right answer than the exercise takes.
     *
     * @throws CatalogueException naming the first case that has one
     */
    static void check(ExerciseFolder folder, Exercise exercise) {
        if (exercise.form() != Exercise.Form.WRITE) return;
        CapsCheck check = new CapsCheck(folder, exercise);
        Exercise.Caps caps = exercise.caps();
        check.hold("items", "field.caps.items", caps.items(), TopicGrading.Call::items);
        check.hold("bytes", "field.caps.bytes", caps.bytes(), check::bytes);
    }

    private void hold(
            String field, String key, OptionalInt most, ToLongFunction<TopicGrading.Call> needed) {
        if (most.isEmpty()) return;
        for (Case one : exercise.cases())
            for (TopicGrading.Call call : topic.calls(one, exercise.tolerance(), 0)) {
                long least = needed.applyAsLong(call);
                if (least > most.getAsInt())
                    throw ExerciseReader.wrong(
                            folder,
                            "caps." + field,
                            Phrase.of(key, one.name(), least, most.getAsInt()));
            }
    }

    /** Counts the bytes of the longest right answer to one call of those that an input takes. */
    private long bytes(TopicGrading.Call call) {
        var right = new Measured(call.caps().items());
        Class<?> type = contract.contract();
        try {
            call.recorded(
                    Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, right),
                    call.caps().items());
            return right.most;
        } catch (LimitReached | IllegalArgumentException cutOrRefused) {
            return right.most;
        }
    }

    /** A right method, whose answers are written down as a child would. */
    private final class Measured implements InvocationHandler {
        private final int items;
        private final HeldArrays arrays = new HeldArrays();
        private int most;

        Measured(int items) {
            this.items = items;
        }

        @Override
        public Object invoke(Object proxy, Method method, Object[] given) throws Throwable {
            if (method.isDefault()) return InvocationHandler.invokeDefault(proxy, method, given);
            ContractCall call = contract.of(method);
            byte[] answer = call.answered(topic.right(), given, items + 1);
            most = Math.max(most, answer.length);
            var in = new DataInputStream(new ByteArrayInputStream(answer));
            return call.replay(in, given, arrays).value();
        }
    }
}
