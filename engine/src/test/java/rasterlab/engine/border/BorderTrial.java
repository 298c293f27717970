package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;

/** Tries every method of a topic that promises to be right on inputs made of border numbers. */
final class BorderTrial<C, I, O> {
    private final Border<C, I, O> border;
    private int inputs;
    private int answers;

    BorderTrial(Border<C, I, O> border) {
        this.border = border;
    }

    /** The right answer of one input, cut as a topic cuts it. */
    private record Right<O>(O exact, boolean cut, int limit) {}

    /**
     * The mistakes of methods, each told once with its numbers made as simple as they get.
     *
     * @param seed of the first input; the next one has the next seed
     */
    List<String> failures(long seed, int count) {
        var methods = new ArrayList<Method<C>>();
        for (Method<C> method : border.topic().methods())
            if (method.promisesToBeRight()) methods.add(method);
        var found = new ArrayList<String>();
        for (long at = seed; at < seed + count && !methods.isEmpty(); at++) {
            Draws draws = Draws.random(at);
            Optional<I> input = input(draws);
            if (input.isEmpty()) continue;
            inputs++;
            Optional<Right<O>> right = right(input.get());
            for (Method<C> method : List.copyOf(methods)) {
                if (complaint(method, input.get(), right).isEmpty()) continue;
                methods.remove(method);
                found.add("seed " + at + ": " + callText(method, draws.drawn()));
            }
        }
        return found;
    }

    /** The numbers that {@link #failures} tried: inputs, and answers to compare. */
    String counted() {
        return inputs + " inputs, " + answers + " answers";
    }

    /** Whether half of the inputs and a quarter of the answers were there to be judged at all. */
    boolean meant(int count) {
        long promising =
                border.topic().methods().stream().filter(Method::promisesToBeRight).count();
        return 2L * inputs >= count && 4L * answers >= inputs * promising;
    }

    private Optional<I> input(Draws draws) {
        try {
            return Optional.of(border.input().apply(draws));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /**
     * The right answer, or empty where there is none: the reference has to divide by 0, or refuses
     * to.
     */
    private Optional<Right<O>> right(I input) {
        try {
            return Optional.of(cut(input));
        } catch (ArithmeticException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private Right<O> cut(I input) {
        int most = border.most();
        O exact = border.topic().exact(input, most + 1);
        long items = border.topic().compare(input, exact, exact).of();
        if (items > most) return new Right<>(border.topic().exact(input, most), true, most);
        return new Right<>(exact, false, (int) border.topic().mostBeforeEndless(items));
    }

    /** The fault of the method's answer to the input. */
    private Optional<String> complaint(Method<C> method, I input, Optional<Right<O>> right) {
        O made;
        int limit = right.map(Right::limit).orElse(border.most());
        try {
            made = border.topic().record(method.implementation(), input, limit);
        } catch (IllegalArgumentException e) {
            boolean may =
                    right.isEmpty()
                            || border.refusals().allowed(method.name(), input, e.getMessage());
            return may ? Optional.empty() : Optional.of("is refused: " + e.getMessage());
        } catch (LimitReached e) {
            if (!right.map(Right::cut).orElse(false)) return Optional.of("gets an endless answer");
            made = recorded(e);
        } catch (RuntimeException | StackOverflowError e) {
            return Optional.of("throws " + e);
        }
        answers++;
        if (right.isEmpty()) return Optional.of("has no answer, got " + Readable.text(made));
        return off(input, right.get(), made);
    }

    private Optional<String> off(I input, Right<O> right, O made) {
        if (!border.promise().test(input, made))
            return Optional.of("breaks a promise of the contract: " + Readable.text(made));
        Deviation deviation = border.topic().compare(input, right.exact(), made);
        return border.topic().correct(deviation)
                        || border.excuse().allows(input, right.exact(), made)
                ? Optional.empty()
                : Optional.of(
                        "is off by %s %s: %s"
                                .formatted(
                                        deviation.worst(),
                                        border.topic().errorUnit(),
                                        deviation.first()));
    }

    @SuppressWarnings("unchecked") // the topic's own sink threw it, with the topic's output
    private O recorded(LimitReached reached) {
        return (O) reached.recorded();
    }

    private String callText(Method<C> method, List<Double> numbers) {
        List<Double> few = Shrinking.shrunk(numbers, each -> wrong(method, each).isPresent());
        return "%s %s on %s of the numbers %s %s"
                .formatted(
                        border.topic().name(),
                        method.name(),
                        input(Draws.of(few)).map(Readable::text).orElseThrow(),
                        few,
                        wrong(method, few).orElseThrow());
    }

    private Optional<String> wrong(Method<C> method, List<Double> numbers) {
        return input(Draws.of(numbers)).flatMap(each -> complaint(method, each, right(each)));
    }
}
