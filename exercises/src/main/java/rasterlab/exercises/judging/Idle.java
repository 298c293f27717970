package rasterlab.exercises.judging;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Message;

/**
 * Tells the answers of a method that does nothing: it sends nothing and leaves what it is given as
 * it is, or what it returns is empty, zeros or false alone. Such an answer may be right, and one
 * wrong answer of the kind tells no mistake; a program that gives no other does nothing.
 */
final class Idle {
    private static final String CODE = "nothing";

    private Idle() {}

    /** The mistake of a method that does nothing, where that may be its output. */
    static <C, I, O> Optional<Cause> cause(ByTopic<C, I, O> grading, I input, O output) {
        Topic<C, I, O> topic = grading.topic();
        Leaves leaves = Leaves.of(topic.format(), input, output);
        if (!sends(grading.contract())) return returned(leaves);
        C idle = grading.whole(doingNothing(grading.contract()));
        O untouched = topic.record(idle, input, topic.mostItems());
        if (!Leaves.of(topic.format(), input, untouched).equals(leaves)) return Optional.empty();
        return Optional.of(cause(hasSink(grading.contract()) ? "sent" : "changed"));
    }

    private static Optional<Cause> returned(Leaves leaves) {
        if (leaves.areNone()) return Optional.of(cause("returned"));
        if (leaves.areFalse()) return Optional.of(cause("but-false"));
        return leaves.areZeros() ? Optional.of(cause("but-zeros")) : Optional.empty();
    }

    private static Cause cause(String kind) {
        return new Cause(CODE, Message.of("mistake.nothing-" + kind));
    }

    /** Whether methods of the contract return nothing: they send or change. */
    private static boolean sends(Class<?> contract) {
        return abstractMethods(contract).map(Method::getReturnType).allMatch(void.class::equals);
    }

    /** Whether its methods send their answer to the last of what they are given. */
    private static boolean hasSink(Class<?> contract) {
        return abstractMethods(contract)
                .map(Method::getParameterTypes)
                .allMatch(given -> given[given.length - 1].isInterface());
    }

    private static Stream<Method> abstractMethods(Class<?> contract) {
        return Stream.of(contract.getMethods())
                .filter(one -> Modifier.isAbstract(one.getModifiers()));
    }

    private static Object doingNothing(Class<?> contract) {
        return Proxy.newProxyInstance(
                contract.getClassLoader(),
                new Class<?>[] {contract},
                (self, method, arguments) -> null);
    }
}
