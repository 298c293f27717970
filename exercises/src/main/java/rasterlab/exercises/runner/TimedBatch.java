package rasterlab.exercises.runner;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.TimedAnswers;
import rasterlab.exercises.TopicGrading.TimingInputs;
import rasterlab.exercises.child.ArrayAliases;
import rasterlab.exercises.child.ContractCall;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.child.Values;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.Request;

/**
 * The calls that a right method gets for the inputs of a batch, to be made of another and timed.
 */
final class TimedBatch {
    static final TimedAnswers NOTHING = new TimedAnswers(0, 0, Optional.empty());

    private final ContractCalls contract;
    private final TimingInputs timing;
    private final TopicGrading.CallLimits caps;
    private final int inputs;
    private final ByteArrayOutputStream arguments = new ByteArrayOutputStream();
    private int calls;
    private int from;
    private int to;

    /**
     * @param caps limits of a call that the exercise states
     */
    TimedBatch(ContractCalls contract, TimingInputs timing, Exercise.StatedLimits caps) {
        this(
                contract,
                timing,
                TopicGrading.CallLimits.ofItems(timing.mostItems()).within(caps),
                0,
                timing.inputs());
    }

    private TimedBatch(
            ContractCalls contract,
            TimingInputs timing,
            TopicGrading.CallLimits caps,
            int firstInput,
            int pastLast) {
        this.contract = contract;
        this.timing = timing;
        this.caps = caps;
        this.inputs = pastLast - firstInput;
        Object listening = StudentMethodProxy.proxy(contract, new Listening());
        int looked = timing.looked().orElse(-1);
        for (int i = firstInput; i < pastLast; i++) {
            if (i == looked) from = calls;
            timing.recorded(i, listening);
            if (i == looked) to = calls;
        }
    }

    /** Writes down what the right method is given. */
    private final class Listening implements InvocationHandler {
        private final DataOutputStream out = new DataOutputStream(arguments);

        @Override
        public Object invoke(Object proxy, Method method, Object[] given) throws Throwable {
            if (method.isDefault()) return InvocationHandler.invokeDefault(proxy, method, given);
            ContractCall call = contract.of(method);
            out.writeInt(call.number());
            call.writeArguments(given, out);
            calls++;
            return call.invoke(timing.right(), given);
        }
    }

    /** This batch for one of the inputs alone. */
    TimedBatch alone(int input) {
        return new TimedBatch(contract, timing, caps, input, input + 1);
    }

    /**
     * Processor time for the batch: what is stated for each of its inputs, but no more than a call
     * may have.
     *
     * @param usual for a call
     */
    Duration limit(Duration usual) {
        if (caps.processor().isEmpty()) return usual;
        Duration each = caps.processor().get();
        Duration most = each.compareTo(usual) > 0 ? each : usual;
        Duration all = each.multipliedBy(inputs);
        return all.compareTo(most) < 0 ? all : most;
    }

    /**
     * Whether one of several inputs may have taken longer than is stated for it.
     *
     * @param nanos that all took
     */
    boolean mayHideALongCall(long nanos) {
        return inputs > 1 && caps.processor().filter(each -> nanos > each.toNanos()).isPresent();
    }

    Request request() {
        return new Request(
                Wire.TIME,
                out -> {
                    out.writeInt(calls);
                    out.writeInt(caps.items());
                    out.writeInt(caps.bytes());
                    out.writeInt(timing.usualItems());
                    out.writeInt(from);
                    out.writeInt(to);
                    arguments.writeTo(out);
                });
    }

    /**
     * The answer to the input that is looked at; empty where none is, or where it cannot be used.
     */
    Optional<Object> looked(DataInputStream in) throws IOException {
        Deque<byte[]> answers = new ArrayDeque<>();
        for (int i = from; i < to; i++) answers.add(Frames.read(in, Wire.MOST_ANSWER_BYTES));
        if (from == to) return Optional.empty();
        try {
            return Optional.of(
                    timing.recorded(
                            timing.looked().getAsInt(),
                            StudentMethodProxy.proxy(contract, new Replaying(answers))));
        } catch (LimitReached | IllegalStateException unusable) {
            return Optional.empty();
        }
    }

    /** Gives one answer after the other. */
    private final class Replaying implements InvocationHandler {
        private final Deque<byte[]> answers;
        private final ArrayAliases arrays = new ArrayAliases();

        Replaying(Deque<byte[]> answers) {
            this.answers = answers;
        }

        @Override
        public Object invoke(Object proxy, Method method, Object[] given) throws Throwable {
            if (method.isDefault()) return InvocationHandler.invokeDefault(proxy, method, given);
            var in = new DataInputStream(new ByteArrayInputStream(answers.remove()));
            ContractCall call = contract.of(method);
            Object value = call.replay(in, given, arrays).value();
            if (call.returnsValue() && value == null)
                throw new IllegalStateException("null is no answer");
            if (Values.hasNull(value)) throw new IllegalStateException("null is in the answer");
            return value;
        }
    }
}
