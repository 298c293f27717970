package rasterlab.exercises.runner;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.study.InputChanged;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.SharedAnswer;
import rasterlab.engine.study.WrongLength;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.CallLimits;
import rasterlab.exercises.TopicGrading.TimedAnswers;
import rasterlab.exercises.child.ContractCall;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.PayloadReader;
import rasterlab.exercises.runner.process.Request;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Message;

/** A loaded class in its running child, called from here one input at a time. */
final class StudentRun {
    private static final Duration MESSAGE_LIMIT = Duration.ofMillis(500);

    private final Child child;
    private final ContractCalls contract;
    private final Duration callLimit;
    private final Patience patience;
    private String thrown = "";
    private boolean over;

    /** Time that the calls made for one input took so far. */
    private Duration spent = Duration.ZERO;

    private boolean first;

    /**
     * @param contract of the class, whose methods are called
     * @param callLimit the most processor time for one call
     */
    StudentRun(Child child, ContractCalls contract, Duration callLimit, Patience patience) {
        this.child = child;
        this.contract = contract;
        this.callLimit = callLimit;
        this.patience = patience;
    }

    /** Processor time that the child used since it was started; none where nobody tells. */
    Duration used() {
        return child.used().orElse(Duration.ZERO);
    }

    /** Whether the child has ended although it answered the last call. */
    boolean over() {
        return over;
    }

    /** Hands the classes in and makes an instance; an answer without an output. */
    Answer load(String entry, Map<String, byte[]> classes) throws ChildLost, InterruptedException {
        Request request =
                new Request(
                        Wire.LOAD,
                        out -> {
                            out.writeUTF(contract.contract().getName());
                            for (ContractCall one : contract.all())
                                Frames.write(out, CallingClass.of(one.method()));
                            out.writeUTF(entry);
                            out.writeInt(classes.size());
                            for (Map.Entry<String, byte[]> one : classes.entrySet()) {
                                out.writeUTF(one.getKey());
                                Frames.write(out, one.getValue());
                            }
                        });
        try {
            return ask(
                    request,
                    callLimit,
                    (status, in) -> {
                        if (status == Wire.NOT_LOADABLE)
                            throw new IOException("cannot make an instance of " + entry);
                        return Answer.without(Answer.CallEnding.RETURNED, "", "", "");
                    });
        } catch (StudentMethodProxy.MethodException threw) {
            return threw.answer();
        }
    }

    /**
     * Has the student's method answer.
     *
     * @throws ChildLost when the child gave no answer; it is dead then
     */
    Answer call(TopicGrading.GradedCall call, CallLimits caps)
            throws ChildLost, InterruptedException {
        spent = Duration.ZERO;
        first = true;
        StudentMethodProxy asked =
                new StudentMethodProxy(
                        contract, (method, arguments) -> send(caps, method, arguments));
        try {
            return asked.with(
                    Answer.CallEnding.RETURNED, call.recorded(asked.method(), caps.items()));
        } catch (LimitReached reached) {
            return asked.with(Answer.CallEnding.CUT, reached.recorded());
        } catch (InputChanged changed) {
            return asked.without(Answer.CallEnding.OVERWROTE, "");
        } catch (WrongLength other) {
            return asked.unusable(Message.of("answer.length", other.got(), other.asked()));
        } catch (SharedAnswer shared) {
            String key = shared.given() ? "answer.shared-given" : "answer.shared-before";
            return asked.unusable(Message.of(key));
        } catch (StudentMethodProxy.Unanswered stopped) {
            Throwable cause = stopped.getCause();
            if (cause instanceof InterruptedException interrupted) throw interrupted;
            if (!(cause instanceof ChildLost lost)) return asked.ended().orElseThrow();
            child.close();
            throw lost;
        } catch (RuntimeException unusable) {
            if (!asked.asked()) throw unusable;
            String message = unusable.getMessage();
            return asked.without(Answer.CallEnding.UNUSABLE, message == null ? "" : message);
        }
    }

    private StudentMethodProxy.CallReply send(
            CallLimits caps, ContractCall method, Object[] arguments)
            throws ChildLost, InterruptedException, StudentMethodProxy.MethodException {
        Request request =
                new Request(
                        Wire.CALL,
                        out -> {
                            out.writeBoolean(first);
                            // with one item more the topic itself finds its limit reached
                            out.writeInt(caps.items() + 1);
                            out.writeInt(caps.bytes());
                            out.writeInt(method.number());
                            method.writeArguments(arguments, out);
                        });
        StudentMethodProxy.CallReply reply =
                askWithin(
                        caps.processor().orElse(callLimit),
                        request,
                        (status, in) -> {
                            if (status != Wire.DONE
                                    && status != Wire.CUT
                                    && status != Wire.TOO_LONG)
                                throw new IOException("status " + status + " after a call");
                            byte[] answer = Frames.read(in, Wire.MOST_ANSWER_BYTES);
                            return new StudentMethodProxy.CallReply(
                                    status, answer, Wire.cut(in.readUTF()));
                        });
        first = false;
        return reply;
    }

    /**
     * The outcome of timed calls.
     *
     * @param nanos measured by this process
     * @param own what the child tells: without the way there and back
     * @param printed number of bytes
     * @param thrown class of an exception; empty where there was none
     * @param tooLong whether an answer has more bytes than are taken
     */
    record Timed(
            long nanos,
            long own,
            TimedAnswers answers,
            long printed,
            String thrown,
            boolean tooLong) {
        static Timed none(long nanos, String thrown, boolean tooLong) {
            return new Timed(nanos, 0, TimedBatch.NOTHING, 0, thrown, tooLong);
        }
    }

    Timed time(TimedBatch batch) throws ChildLost, InterruptedException {
        long start = System.nanoTime();
        return child.ask(
                batch.request(),
                patience.limit(batch.limit(callLimit)),
                (status, in) -> {
                    long nanos = System.nanoTime() - start;
                    if (status == Wire.THREW)
                        return Timed.none(nanos, Wire.cut(in.readUTF()), false);
                    if (status != Wire.DONE) return Timed.none(nanos, "", status == Wire.TOO_LONG);
                    long own = in.readLong();
                    long count = in.readLong();
                    long sum = in.readLong();
                    long printed = in.readLong();
                    TimedAnswers told = new TimedAnswers(count, sum, batch.looked(in));
                    return new Timed(nanos, own, told, printed, "", false);
                });
    }

    /**
     * Asks in what is left of a limit for all calls that are made for one input.
     *
     * @throws ChildLost also when nothing is left, naming the whole limit
     */
    private <T> T askWithin(Duration limit, Request request, PayloadReader<T> reading)
            throws ChildLost, InterruptedException, StudentMethodProxy.MethodException {
        Duration before = used();
        long start = System.nanoTime();
        T answer;
        try {
            answer = ask(request, limit.minus(spent), reading);
            Duration passed = Duration.ofNanos(System.nanoTime() - start);
            spent = spent.plus(child.used().map(now -> now.minus(before)).orElse(passed));
        } catch (ChildLost lost) {
            if (lost.reason() != ChildLost.LossReason.TIME || lost.isIdle()) throw lost;
            throw ChildLost.late(patience.limit(limit), limit);
        }
        if (spent.compareTo(limit) < 0) return answer;
        child.close();
        throw ChildLost.late(patience.limit(limit), spent);
    }

    private <T> T ask(Request request, Duration limit, PayloadReader<T> reading)
            throws ChildLost, InterruptedException, StudentMethodProxy.MethodException {
        Optional<T> answer =
                child.ask(
                        request,
                        patience.limit(limit),
                        (status, in) -> {
                            if (status != Wire.THREW) return Optional.of(reading.read(status, in));
                            thrown = Wire.cut(in.readUTF());
                            return Optional.empty();
                        });
        if (answer.isPresent()) return answer.get();
        throw new StudentMethodProxy.MethodException(withMessage(thrown));
    }

    /** The message comes by itself, since asking for it runs the student's code once more. */
    private Answer withMessage(String exception) throws InterruptedException {
        try {
            return child.more(
                    patience.limit(MESSAGE_LIMIT),
                    (status, in) -> {
                        String message = Wire.cut(in.readUTF());
                        String printed = Wire.cut(in.readUTF());
                        int line = Math.max(0, in.readInt());
                        return Answer.threw(exception, message, line, printed);
                    });
        } catch (ChildLost lost) {
            over = true;
            return Answer.threw(exception, "", 0, "");
        }
    }
}
