package rasterlab.engine.study;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;
import rasterlab.engine.format.AnswerLimitReached;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.ObjectShape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;

/**
 * Describes a topic's inputs and answers outside the engine.
 *
 * <p>A topic says its fields, how an input is made of them and how an output is written. Where it
 * takes or answers more than that, such as limits, a window or steps, it overrides a part of {@link
 * #prepared}.
 *
 * @param <C> the contract that methods implement
 * @param <I> one input
 * @param <O> one recorded output
 */
public abstract class Format<C, I, O> {
    private final Topic<C, I, O> topic;

    protected Format(Topic<C, I, O> topic) {
        this.topic = topic;
    }

    public final Topic<C, I, O> topic() {
        return topic;
    }

    /** The fields of an input. */
    public abstract List<Field<?>> input();

    /** The fields that go together in an input, a list for each form that it may have. */
    public List<List<Field<?>>> forms() {
        return List.of(input());
    }

    /** Whether an input may have fields whose names {@link #read} looks at by itself. */
    public boolean open() {
        return false;
    }

    /**
     * Groups of fields of which an input has exactly one, with all its fields; none where that does
     * not matter.
     */
    protected List<List<Field<?>>> groups() {
        return List.of();
    }

    /** Writes what a schema says about an input, without what stands around it. */
    protected void writeInputSchema(ValueSink out) throws IOException {
        new ObjectShape(input()).writeSchema(out);
        if (!groups().isEmpty()) TopicSchema.writeOneOf(groups(), out);
    }

    /** The fields of an answer, but for those of its steps. */
    public abstract List<Field<?>> answer();

    /** The fields of an input for people, each with what stands for its value. */
    public abstract String reads();

    /** The fields of an answer for people. */
    public abstract String answers();

    /** Whether any method of the topic has steps. */
    public boolean hasSteps() {
        return true;
    }

    /**
     * Makes an input of its fields.
     *
     * @throws InvalidInput if they do not go together
     */
    public abstract I read(Given given);

    /**
     * The fields of which {@link #read} makes that input.
     *
     * @param input one of {@link #singles}
     * @throws IllegalArgumentException if there are none, since it has what is not told outside
     */
    protected abstract Given given(I input);

    /** The inputs as they are outside that make up {@code input}; mostly that one. */
    public List<I> singles(I input) {
        return List.of(input);
    }

    /**
     * Writes the fields of an input so that it is read as the same.
     *
     * @param input one of {@link #singles}
     * @throws IllegalArgumentException if it has what is not told outside
     */
    public final void writeInput(I input, ValueSink out) throws IOException {
        given(input).write(input(), out);
    }

    /**
     * Writes the fields of an output: what the topic judges.
     *
     * @param input that it answers
     */
    public abstract void write(I input, O output, ValueSink out) throws IOException;

    /**
     * Reads an input, refuses at once what cannot be done, and returns what is left to do: to run
     * the method, which may crash or never end.
     *
     * @return refuses by {@link IllegalArgumentException}; {@link InvalidInput} and {@link
     *     AnswerLimitReached} where the answer asked for cannot be had
     * @throws InvalidInput if the fields are no input, or ask for too much
     */
    public Supplier<Written> prepared(Call<C> call, Given given) {
        return prepared(call, read(given));
    }

    /**
     * Prepares a call for an input of the topic's own, which may have what is not told outside.
     *
     * @param input one of {@link #singles}
     */
    public final Supplier<Written> prepared(Call<C> call, I input) {
        check(call, input);
        return new Run(call, input);
    }

    /**
     * Refuses what could not end within seconds, or a method without steps, by {@link
     * InvalidInput}.
     */
    protected void check(Call<C> call, I input) {}

    /** Runs the method and keeps what it answers. */
    protected Written answered(Call<C> call, I input) {
        O output = recorded(call, input);
        return answer(input, output, null, call.steps() ? steps(call, input) : null);
    }

    /**
     * Puts an answer together: the output, behind it what is told beyond it, and the steps.
     *
     * @param more null where nothing is
     * @param steps null where none were asked for
     */
    protected final Written answer(I input, O output, Written more, Written steps) {
        return new Whole(input, output, more, steps);
    }

    /** The method's output for the input. */
    protected O recorded(Call<C> call, I input) {
        return topic.record(call.method(), input, Integer.MAX_VALUE);
    }

    /** The steps of the method, walked to their end. */
    protected Written steps(Call<C> call, I input) {
        throw call.noSteps();
    }

    /** The rest of the work: to run the method. */
    private final class Run implements Supplier<Written> {
        private final Call<C> call;
        private final I input;

        Run(Call<C> call, I input) {
            this.call = call;
            this.input = input;
        }

        @Override
        public Written get() {
            return answered(call, input);
        }
    }

    /** An output, with more and with steps where there are such. */
    private final class Whole implements Written {
        private final I input;
        private final O output;
        private final Written more;
        private final Written steps;

        Whole(I input, O output, Written more, Written steps) {
            this.input = input;
            this.output = output;
            this.more = more;
            this.steps = steps;
        }

        @Override
        public void write(ValueSink out) throws IOException {
            Format.this.write(input, output, out);
            if (more != null) more.write(out);
            if (steps != null) steps.write(out);
        }
    }
}
