package rasterlab.exercises.line;

import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.FirstDifference;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.Plotted;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.exercises.drawing.PixelPictures;
import rasterlab.exercises.judging.Failure;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** Compares what a method drew with the exact line, as the case and the exercise demand. */
public final class LineJudge {
    /** The method of the topic that draws what is asked for. */
    private static final String REFERENCE = "bresenham";

    private static final JsonMapper MAPPER = new JsonMapper();

    private final LineTopic topic = new LineTopic();
    private final LineCase demand;
    private final boolean eitherOnTies;

    /**
     * @param eitherOnTies whether the exercise tolerates either pixel of a tie
     */
    public LineJudge(LineCase demand, boolean eitherOnTies) {
        this.demand = demand;
        this.eitherOnTies = eitherOnTies && !demand.strictTies();
    }

    /** The finding with pictures and the textbook method that draws the same. */
    public Finding judge(Segment segment, Answer answer) {
        return judged(segment, answer, true);
    }

    /** The same without what takes time. */
    public Finding check(Segment segment, Answer answer) {
        return judged(segment, answer, false);
    }

    private Finding judged(Segment segment, Answer answer, boolean whole) {
        Optional<Plotted> plotted = plotted(answer);
        return plotted.isEmpty()
                ? Failure.of(answer, demand.mayRefuse())
                : judged(segment, plotted.get(), whole);
    }

    /** What was plotted; empty where the method threw. */
    static Optional<Plotted> plotted(Answer answer) {
        boolean cut = answer.ending() == Answer.Ending.CUT;
        return answer.output().map(output -> new Plotted((PixelRecording) output, cut));
    }

    private Finding judged(Segment segment, Plotted plotted, boolean whole) {
        boolean cut = demand.cutShort(segment);
        int limit = cut ? demand.firstPixels() : (int) segment.steps() + 1;
        PixelRecording actual = plotted.pixels();
        WantedPixels pixels = new WantedPixels(segment);
        PixelRecording wanted = wanted(pixels, actual, limit);
        if (plotted.cut() && !cut) {
            Message endless = Message.of("still-plotting", actual.size(), wanted.size());
            List<List<Cause>> cause = List.of(List.of(Cause.of("endless")));
            Finding finding = Finding.of(GradingVerdict.OUTPUT_LIMIT, endless, cause);
            return whole ? shown(finding, wanted, actual) : finding;
        }
        if (same(wanted, actual)) return Finding.OK;
        List<List<Cause>> causes = new LineMistakes(segment, limit, cut, eitherOnTies).of(actual);
        if (!whole) return Finding.of(GradingVerdict.WRONG, Message.NONE, causes);
        if (cut && isOnlyAgain(causes)) wanted = wanted(pixels, actual, PixelSet.of(actual).size());
        Message said = said(FirstDifference.of(wanted, actual).orElseThrow());
        for (Cause cause : causes.stream().findFirst().orElse(List.of()))
            said = said.and(cause.said());
        Finding wrong =
                Finding.of(GradingVerdict.WRONG, said.and(knownFault(segment, actual)), causes);
        return shown(wrong, wanted, actual);
    }

    private PixelRecording wanted(WantedPixels pixels, PixelRecording actual, int limit) {
        return eitherOnTies ? pixels.nearest(actual, limit) : pixels.exact(limit);
    }

    /** Then no pixel is missing: what comes twice takes the place of what lies beyond the cut. */
    private static boolean isOnlyAgain(List<List<Cause>> causes) {
        return causes.stream().anyMatch(one -> Cause.codes(one).equals(List.of("again")));
    }

    private static Message said(FirstDifference first) {
        return first.drawn()
                .map(drawn -> Message.of("pixel.instead", first.pixel(), drawn))
                .orElseGet(
                        () -> {
                            String kind = first.kind().name().toLowerCase(Locale.ROOT);
                            return Message.of("pixel." + kind, first.pixel());
                        });
    }

    /** Names the faulty textbook method that draws the very same; nothing where none does. */
    private Message knownFault(Segment segment, PixelRecording actual) {
        for (Method<LineRasterizer> method : topic.methods())
            if (method.faulty() && same(actual, drawnBy(method, segment)))
                return Message.of("known-fault", method.name());
        return Message.NONE;
    }

    private PixelRecording drawnBy(Method<LineRasterizer> method, Segment segment) {
        try {
            return topic.record(method.implementation(), segment, demand.mostPixels(segment));
        } catch (LimitReached reached) {
            return (PixelRecording) reached.recorded();
        }
    }

    private static boolean same(PixelRecording one, PixelRecording other) {
        if (one.size() != other.size()) return false;
        for (int i = 0; i < one.size(); i++)
            if (one.x(i) != other.x(i) || one.y(i) != other.y(i)) return false;
        return true;
    }

    private static Finding shown(Finding finding, PixelRecording wanted, PixelRecording actual) {
        PixelDifference difference = PixelDifference.of(wanted, actual);
        PixelSet amiss = PixelSet.of(new Turns(wanted, actual).amiss(difference));
        return new Finding(
                finding.verdict(),
                finding.said(),
                FirstDifference.of(wanted, actual)
                        .map(
                                first ->
                                        PixelPictures.of(
                                                difference,
                                                amiss.filter(difference.right()::contains),
                                                first.pixel()))
                        .orElse(List.of()),
                finding.explanations());
    }

    /**
     * The case's segment as a scene file that the lab opens, with the method that is right.
     *
     * @param drawn by the student's method, where it is kept
     */
    public static String scene(Segment segment, Optional<Plotted> drawn) {
        ObjectNode input = MAPPER.createObjectNode();
        input.putArray("from").add(segment.x0()).add(segment.y0());
        input.putArray("to").add(segment.x1()).add(segment.y1());
        return new MethodCase(
                        "line",
                        Optional.of(REFERENCE),
                        input.toString(),
                        drawn.map(MethodCase.Drawn::of))
                .write();
    }
}
