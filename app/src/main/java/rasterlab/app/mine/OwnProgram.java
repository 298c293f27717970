package rasterlab.app.mine;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import rasterlab.engine.study.NoAnswer;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.runner.CalledProgram;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.topic.TopicGradings;

/** A source from an exercise as a method that is compiled when it is first called. */
public final class OwnProgram implements AutoCloseable {
    private final Exercise exercise;
    private final String source;
    private final Supplier<Judge> judge;
    private final Object method;
    private final Awaiting awaiting = new Awaiting(System::nanoTime);
    private Optional<CalledProgram> compiled = Optional.empty();
    private Optional<NoAnswer> refused = Optional.empty();
    private boolean closed;

    OwnProgram(Exercise exercise, String source, Supplier<Judge> judge) {
        this.exercise = exercise;
        this.source = source;
        this.judge = judge;
        TopicGrading topic = TopicGradings.of(exercise);
        Object called =
                Proxy.newProxyInstance(
                        topic.contract().getClassLoader(),
                        new Class<?>[] {topic.contract()},
                        (proxy, one, arguments) -> answer(proxy, one, arguments));
        method = topic.asMethod(called);
    }

    boolean isOf(Exercise other, String otherSource) {
        return exercise.id().equals(other.id()) && source.equals(otherSource);
    }

    /** Where it comes from. */
    public Exercise exercise() {
        return exercise;
    }

    /** A method of the topic's contract. */
    Object method() {
        return method;
    }

    /** Compiles it unless that was done; what is wrong with it is told when it is called. */
    public void prepare() {
        try {
            called();
        } catch (NoAnswer unusable) {
            // told again by every call
            return;
        }
    }

    /** Why it cannot run, once it is compiled; empty where it can. */
    public Optional<String> obstacle() {
        try {
            called();
            return Optional.empty();
        } catch (NoAnswer unusable) {
            return Optional.of(unusable.getMessage());
        }
    }

    /**
     * A right method of the topic's contract that the program's time is held against, in this
     * process; empty where there is none, or the program does not run.
     */
    public Optional<Object> reference() throws InterruptedException {
        try {
            return called().reference().map(TopicGradings.of(exercise)::asMethod);
        } catch (NoAnswer unusable) {
            return Optional.empty();
        }
    }

    /**
     * How many times as long as the reference the program takes for those inputs of its topic;
     * empty where that cannot be told.
     */
    public OptionalDouble slowness(List<?> inputs) throws InterruptedException {
        try {
            return called().slowness(inputs);
        } catch (NoAnswer unusable) {
            return OptionalDouble.empty();
        }
    }

    private Object answer(Object proxy, java.lang.reflect.Method one, Object[] arguments)
            throws Throwable {
        if (one.isDefault()) return InvocationHandler.invokeDefault(proxy, one, arguments);
        if (one.getDeclaringClass() == Object.class) return one.invoke(this, arguments);
        awaiting.begin();
        try {
            return called().call(one, arguments);
        } finally {
            awaiting.end();
        }
    }

    /** Whether a lab has been waiting that long for what it asked the program. */
    public boolean isAwaited(Duration least) {
        return awaiting.lasts(least);
    }

    /** A fault of the source stays a fault: it is not compiled again. */
    private synchronized CalledProgram called() {
        if (closed) throw gone();
        if (refused.isPresent()) throw refused.get();
        if (compiled.isPresent()) return compiled.get();
        try {
            compiled = Optional.of(judge.get().program(exercise, source));
            return compiled.get();
        } catch (NoAnswer wrong) {
            refused = Optional.of(wrong);
            throw wrong;
        } catch (InterruptedException givenUp) {
            Thread.currentThread().interrupt();
            throw gone();
        }
    }

    private static NoAnswer gone() {
        return new NoAnswer(Verdict.Kind.CRASHED, "your program was ended from outside");
    }

    /** Ends its process. */
    @Override
    public void close() {
        Optional<CalledProgram> running;
        synchronized (this) {
            closed = true;
            running = compiled;
        }
        running.ifPresent(CalledProgram::close);
    }
}
