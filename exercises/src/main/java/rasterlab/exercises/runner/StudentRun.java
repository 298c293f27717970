package rasterlab.exercises.runner;

import java.io.DataInputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.score.Answer;

/** A loaded class in its running child, called from here one input at a time. */
final class StudentRun {
    private static final Duration MESSAGE_LIMIT = Duration.ofMillis(500);

    private final Child child;
    private final Duration callLimit;
    private final Patience patience;
    private boolean over;

    /**
     * @param callLimit processor time for one call
     */
    StudentRun(Child child, Duration callLimit, Patience patience) {
        this.child = child;
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

    /** Hands the classes in and makes an instance; an answer without pixels. */
    Answer load(String entry, Map<String, byte[]> classes) throws ChildLost, InterruptedException {
        return call(
                new Request(
                        Wire.LOAD,
                        out -> {
                            out.writeUTF(entry);
                            out.writeInt(classes.size());
                            for (Map.Entry<String, byte[]> one : classes.entrySet()) {
                                out.writeUTF(one.getKey());
                                Frames.write(out, one.getValue());
                            }
                        }),
                (status, in) -> {
                    if (status == Wire.NOT_LOADABLE)
                        throw new IOException("cannot make an instance of " + entry);
                    return returned(new PixelRecording(1), "");
                });
    }

    Answer call(TopicGrading.Call call) throws ChildLost, InterruptedException {
        return call(
                new Request(call.operation(), call::writeTo),
                (status, in) -> drawn(status, in, call.mostPixels()));
    }

    /**
     * What came of drawing into a sink that sums up.
     *
     * @param nanos measured by this process
     * @param own what the child tells: without the way there and back
     * @param printed number of bytes
     * @param thrown class of an exception; empty where there was none
     */
    record Timed(long nanos, long own, long count, long sum, long printed, String thrown) {}

    Timed time(TopicGrading.Timing timing) throws ChildLost, InterruptedException {
        Request request = new Request(timing.operation(), timing::writeTo);
        long start = System.nanoTime();
        return child.ask(
                request,
                patience.limit(callLimit),
                (status, in) -> {
                    long nanos = System.nanoTime() - start;
                    return status == Wire.DONE
                            ? new Timed(
                                    nanos,
                                    in.readLong(),
                                    in.readLong(),
                                    in.readLong(),
                                    in.readLong(),
                                    "")
                            : new Timed(nanos, 0, 0, 0, 0, Wire.cut(in.readUTF()));
                });
    }

    private Answer call(Request request, Reading<Answer> reading)
            throws ChildLost, InterruptedException {
        Answer answer =
                child.ask(
                        request,
                        patience.limit(callLimit),
                        (status, in) ->
                                status == Wire.THREW
                                        ? threw(in.readUTF(), "", "", 0)
                                        : reading.read(status, in));
        return answer.ending() == Answer.Ending.THREW ? withMessage(answer) : answer;
    }

    /** The message comes by itself, since asking for it runs the student's code once more. */
    private Answer withMessage(Answer threw) throws InterruptedException {
        try {
            return child.more(
                    patience.limit(MESSAGE_LIMIT),
                    (status, in) ->
                            threw(
                                    threw.exception(),
                                    Wire.cut(in.readUTF()),
                                    Wire.cut(in.readUTF()),
                                    in.readInt()));
        } catch (ChildLost lost) {
            over = true;
            return threw;
        }
    }

    private static Answer drawn(int status, DataInputStream in, int most) throws IOException {
        if (status != Wire.DONE && status != Wire.CUT)
            throw new IOException("status " + status + " after drawing");
        int size = in.readInt();
        if (size < 0 || size > most)
            throw new IOException(size + " pixels, at most " + most + " are allowed");
        PixelRecording pixels = new PixelRecording(Math.max(1, most));
        for (int i = 0; i < size; i++) pixels.plot(in.readInt(), in.readInt());
        String printed = Wire.cut(in.readUTF());
        return status == Wire.DONE
                ? returned(pixels, printed)
                : new Answer(Answer.Ending.CUT, pixels, "", "", 0, printed);
    }

    private static Answer returned(PixelRecording pixels, String printed) {
        return new Answer(Answer.Ending.RETURNED, pixels, "", "", 0, printed);
    }

    private static Answer threw(String exception, String message, String printed, int line) {
        return new Answer(
                Answer.Ending.THREW,
                new PixelRecording(1),
                Wire.cut(exception),
                message,
                line,
                printed);
    }
}
