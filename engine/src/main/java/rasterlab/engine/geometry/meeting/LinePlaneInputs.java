package rasterlab.engine.geometry.meeting;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.Workload;

/** Lines and planes on which methods fail, and those to measure. */
final class LinePlaneInputs {
    private static final long SEED = 230;
    private static final Vector O = at(0, 0, 0);
    private static final Plane LEVEL = new Plane(at(0, 0, 2), 8);

    private LinePlaneInputs() {}

    private static Vector at(double x, double y, double z) {
        return new Vector(x, y, z);
    }

    static List<Hazard<PlaneAndLines>> hazards() {
        return List.of(
                hazard(
                        "three-points",
                        Plane.through(at(1, 0, 0), at(0, 2, 0), at(0, 0, 3)),
                        new Line(O, at(1, 2, 3)),
                        recorded(EXACT, EXACT, EXACT)),
                hazard(
                        "parallel",
                        LEVEL,
                        new Line(at(0, 0, 1), at(1, 1, 1)),
                        recorded(WRONG, REFUSED, REFUSED)),
                hazard(
                        "in-the-plane",
                        LEVEL,
                        new Line(at(0, 0, 4), at(1, 1, 4)),
                        recorded(WRONG, REFUSED, REFUSED)),
                hazard(
                        "nearly-parallel",
                        new Plane(at(1, 1, 1), 2),
                        new Line(at(0.1, 0.2, 0.3), at(1e8 + 0.1, -1e8 + 0.2, 0.3 + 1e-7)),
                        recorded(WRONG, WRONG, EXACT)),
                hazard(
                        "huge",
                        new Plane(at(0, 1e200, 2e200), 8e300),
                        new Line(at(1e200, 1e200, 0), at(2e200, 1e200, 1e200)),
                        recorded(WRONG, EXACT, EXACT)),
                hazard(
                        "tiny",
                        Plane.through(at(1e-200, 0, 0), at(0, 2e-200, 0), at(0, 0, 3e-200)),
                        new Line(O, at(1e-200, 2e-200, 3e-200)),
                        recorded(EXACT, EXACT, EXACT)),
                hazard(
                        "vanishing-slope",
                        new Plane(at(0, 0, 1e-200), 1e-300),
                        new Line(O, at(0, 1e-200, 1e-200)),
                        recorded(WRONG, EXACT, EXACT)),
                hazard(
                        "beyond-doubles",
                        new Plane(at(0, 0, 1), 1e200),
                        new Line(O, at(1, 0, 1e-200)),
                        recorded(WRONG, REFUSED, REFUSED)),
                far(),
                longLine(),
                atSecondPoint());
    }

    private static Hazard<PlaneAndLines> far() {
        Vector point = at(100_000_000.3, 0, 0);
        Plane plane = Plane.through(point, at(0.1, 0.3, 0.7));
        var line = new Line(at(100_000_000.1, 0, 0), at(100_000_001.1, 0, 0));
        return new Hazard<>(
                "plane-far-away",
                new PlaneAndLines(plane, Optional.of(point), List.of(line)),
                recorded(WRONG, WRONG, EXACT));
    }

    private static Hazard<PlaneAndLines> longLine() {
        return hazard(
                "point-near-the-start",
                new Plane(at(1, 0, 0), 1),
                new Line(O, at(1e20, 0, 0)),
                recorded(EXACT, EXACT, EXACT));
    }

    /** Rounded products make 1.0000000000000002 of it, which is beyond. */
    private static Hazard<PlaneAndLines> atSecondPoint() {
        Vector end = at(0.7, 0.9, 0.7);
        Plane plane = Plane.through(end, at(0.5, 0.2, 0.5));
        return new Hazard<>(
                "at-the-second-point",
                new PlaneAndLines(plane, Optional.of(end), List.of(new Line(at(0, 0.2, 0.4), end))),
                recorded(DEGRADED, DEGRADED, EXACT));
    }

    private static Hazard<PlaneAndLines> hazard(
            String name, Plane plane, Line line, Map<String, Verdict.Kind> recorded) {
        return new Hazard<>(name, new PlaneAndLines(plane, List.of(line)), recorded);
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind textbook, Verdict.Kind formula, Verdict.Kind unrounded) {
        return Map.of("formula-textbook", textbook, "formula", formula, "unrounded", unrounded);
    }

    static List<Workload<PlaneAndLines>> workloads() {
        return List.of(lines(1), lines(16), lines(256), lines(4_096));
    }

    private static Workload<PlaneAndLines> lines(int count) {
        var random = new Random(SEED + count);
        var inputs = new ArrayList<PlaneAndLines>();
        for (int i = 0; i < 4_096 / Math.max(count, 64); i++) {
            var lines = new ArrayList<Line>();
            for (int k = 0; k < count; k++) lines.add(new Line(anywhere(random), anywhere(random)));
            inputs.add(new PlaneAndLines(Plane.through(anywhere(random), anywhere(random)), lines));
        }
        return new Workload<>("lines-" + count, count, inputs);
    }

    private static Vector anywhere(Random random) {
        return at(
                random.nextDouble(-100, 100),
                random.nextDouble(-100, 100),
                random.nextDouble(-100, 100));
    }
}
