package rasterlab.exercises.child;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Array;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.SharedAnswer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.WrongLength;
import rasterlab.exercises.Contracts;

/** An answer of another shape than was asked for is never right, and never breaks the judge. */
class MisshapenAnswersTest {
    private static final int HAZARDS = 6;

    /** The methods that the judge has words for. */
    private static final Set<Class<?>> TOLD =
            Set.of(WrongLength.class, SharedAnswer.class, LimitReached.class);

    private record Change(String name, UnaryOperator<Object> of) {}

    private static final List<Change> CHANGES =
            List.of(
                    new Change("empty", value -> ofLength(value, 0)),
                    new Change("one less", value -> ofLength(value, Array.getLength(value) - 1)),
                    new Change("one more", value -> ofLength(value, Array.getLength(value) + 1)),
                    new Change("not numbers", MisshapenAnswersTest::withoutNumbers));

    static Stream<Named<Topic<?, ?, ?>>> topics() {
        return Contracts.topics().stream()
                .filter(
                        topic ->
                                ContractCalls.of(Contracts.of(topic)).all().stream()
                                        .anyMatch(one -> one.method().getReturnType().isArray()))
                .map(topic -> Named.of(topic.name(), topic));
    }

    private static Object ofLength(Object value, int length) {
        if (length < 0) return value;
        Object other = Array.newInstance(value.getClass().getComponentType(), length);
        System.arraycopy(value, 0, other, 0, Math.min(length, Array.getLength(value)));
        return other;
    }

    private static Object withoutNumbers(Object value) {
        if (value instanceof Object[] rows) {
            Object[] others = rows.clone();
            for (int i = 0; i < others.length; i++) others[i] = withoutNumbers(rows[i]);
            return others;
        }
        if (!(value instanceof double[] numbers)) return ofLength(value, 0);
        double[] others = numbers.clone();
        Arrays.fill(others, Double.NaN);
        return others;
    }

    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void isNeverRight(Topic<C, I, O> topic) {
        Method<C> method = topic.methods().stream().filter(m -> !m.faulty()).findFirst().get();
        ContractCalls contract = ContractCalls.of(Contracts.of(topic));
        int tried = 0;
        for (Hazard<I> hazard : topic.hazards()) {
            if (!isRight(topic, method.implementation(), hazard.input())) continue;
            if (tried++ == HAZARDS) break;
            for (Change change : CHANGES) {
                boolean[] changed = new boolean[1];
                CalledHere.Answering wire = CalledHere.calling();
                C spoilt =
                        CalledHere.remote(
                                contract,
                                method.implementation(),
                                (call, right, given) -> {
                                    Object value = call.invoke(right, given);
                                    Object other = change.of().apply(value);
                                    changed[0] |= !Arrays.deepEquals(array(value), array(other));
                                    return other;
                                });
                C remote = CalledHere.remote(contract, spoilt, wire);
                boolean right = isRight(topic, remote, hazard.input());
                assertFalse(right && changed[0], hazard.name() + ": " + change.name());
            }
        }
        assertTrue(tried > 0, "no hazard is answered");
    }

    private static Object[] array(Object value) {
        return new Object[] {value};
    }

    private static <C, I, O> boolean isRight(Topic<C, I, O> topic, C method, I input) {
        O output;
        try {
            output = topic.record(method, input, CalledHere.MOST);
        } catch (IllegalArgumentException refused) {
            return false;
        } catch (RuntimeException told) {
            assertTrue(
                    TOLD.contains(told.getClass()),
                    () -> told + Arrays.toString(told.getStackTrace()));
            return false;
        }
        O exact = topic.exact(input, CalledHere.MOST);
        return topic.correct(topic.compare(input, exact, output));
    }

    /** A promise of a new array could otherwise not be checked. */
    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void anArrayThatOthersHoldIsToldAsWhereItIsMade(Topic<C, I, O> topic) {
        Method<C> method = topic.methods().stream().filter(m -> !m.faulty()).findFirst().get();
        ContractCalls contract = ContractCalls.of(Contracts.of(topic));
        for (Hazard<I> hazard : topic.hazards())
            for (boolean given : new boolean[] {true, false}) {
                String here =
                        outcome(topic, sharing(contract, method.implementation(), given), hazard);
                C sharing = sharing(contract, method.implementation(), given);
                C remote = CalledHere.remote(contract, sharing, CalledHere.calling());
                assertEquals(here, outcome(topic, remote, hazard), hazard.name());
            }
    }

    /** Answers in an array that it was given, or in that of its last answer. */
    private static <C> C sharing(ContractCalls contract, C right, boolean given) {
        Object[] last = new Object[1];
        return CalledHere.remote(
                contract,
                right,
                (call, method, arguments) -> {
                    Object value = call.invoke(method, arguments);
                    Object other =
                            given
                                    ? Stream.of(arguments)
                                            .filter(one -> fits(one, value))
                                            .findFirst()
                                            .orElse(value)
                                    : fits(last[0], value) ? last[0] : value;
                    if (other != value)
                        System.arraycopy(value, 0, other, 0, Array.getLength(value));
                    last[0] = other;
                    return other;
                });
    }

    private static boolean fits(Object other, Object value) {
        return other != null
                && other.getClass() == value.getClass()
                && Array.getLength(other) == Array.getLength(value);
    }

    private static <C, I, O> String outcome(Topic<C, I, O> topic, C method, Hazard<I> hazard) {
        try {
            O output = topic.record(method, hazard.input(), CalledHere.MOST);
            O exact = topic.exact(hazard.input(), CalledHere.MOST);
            return topic.compare(hazard.input(), exact, output).toString();
        } catch (RuntimeException told) {
            return told.toString();
        }
    }
}
