package rasterlab.exercises.line;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.Message;

/** How the topic {@code line} is graded: each call draws one segment. */
public final class LineGrading implements TopicGrading {
    @Override
    public String name() {
        return "line";
    }

    @Override
    public Class<?> contract() {
        return LineRasterizer.class;
    }

    @Override
    public List<Call> calls(Case one, Tolerance tolerance, long seed) {
        LineCase demand = LineCaseReader.read(one, seed);
        LineJudge judge = new LineJudge(demand, tolerance.eitherPixelOnTies());
        return demand.segments().stream()
                .<Call>map(segment -> new SegmentCall(segment, demand, judge))
                .toList();
    }

    @Override
    public Set<String> mistakes() {
        return LineMistakes.CODES;
    }

    @Override
    public Class<?> reference() {
        return PlainBresenham.class;
    }

    /** A long line to begin with. */
    public static Call warmUp() {
        Segment segment = new Segment(0, 0, LineTiming.STEPS, LineTiming.STEPS / 2);
        LineCase demand = new LineCase(List.of(segment), false, LineCase.MOST_PIXELS, false);
        return new SegmentCall(segment, demand, new LineJudge(demand, true));
    }

    @Override
    public String inOwnWords(String key) {
        return key;
    }

    @Override
    public Timings timings(Exercise exercise, Random random, Collection<Set<String>> wrongOn) {
        return new LineTimings(random, wrongOn);
    }

    private record SegmentCall(Segment segment, LineCase demand, LineJudge judge) implements Call {
        @Override
        public Caps caps() {
            return Caps.ofItems(demand.mostPixels(segment));
        }

        @Override
        public long items() {
            return demand.cutShort(segment) ? demand.firstPixels() : segment.steps() + 1;
        }

        @Override
        public Object recorded(Object method, int most) {
            return new LineTopic().record((LineRasterizer) method, segment, most);
        }

        @Override
        public Finding judge(Answer answer) {
            return judge.judge(segment, answer);
        }

        @Override
        public Finding check(Answer answer) {
            return judge.check(segment, answer);
        }

        @Override
        public Set<String> traits() {
            Set<String> traits = new LinkedHashSet<>(LineTraits.of(segment));
            if (demand.cutShort(segment)) traits.add("cut");
            return traits;
        }

        @Override
        public Message example() {
            return Message.of(
                    "line.example",
                    new Pixel(segment.x0(), segment.y0()),
                    new Pixel(segment.x1(), segment.y1()));
        }

        @Override
        public String scene(Optional<Answer> wrong) {
            return LineJudge.scene(segment, wrong.flatMap(LineJudge::plotted));
        }
    }
}
