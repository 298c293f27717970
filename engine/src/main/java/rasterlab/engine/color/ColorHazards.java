package rasterlab.engine.color;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Colours on which careless formulas fail. */
final class ColorHazards {
    private ColorHazards() {}

    static List<Hazard<Colors>> all() {
        return Stream.of(corners(), grays(), ranges()).flatMap(List::stream).toList();
    }

    private static List<Hazard<Colors>> corners() {
        return List.of(
                hazard(
                        "pure-colours",
                        Colors.of(
                                ColorModel.RGB,
                                1,
                                0,
                                0,
                                1,
                                1,
                                0,
                                0,
                                1,
                                0,
                                0,
                                1,
                                1,
                                0,
                                0,
                                1,
                                1,
                                0,
                                1),
                        EXACT,
                        DEGRADED,
                        EXACT),
                hazard("full-turn", Colors.of(ColorModel.HSV, 360, 1, 0.5), EXACT, DEGRADED, EXACT),
                hazard(
                        "to-itself",
                        Colors.of(ColorModel.HSV, 210, 0.6, 0.7, 360, 0.5, 0.5, 77, 0, 0.5),
                        WRONG,
                        DEGRADED,
                        EXACT),
                hazard(
                        "between-levels",
                        Colors.of(ColorModel.RGB, 0.301, 0.6999, 0.4567),
                        EXACT,
                        DEGRADED,
                        EXACT));
    }

    private static List<Hazard<Colors>> grays() {
        return List.of(
                hazard("grey", Colors.of(ColorModel.RGB, 0.6, 0.6, 0.6), WRONG, EXACT, EXACT),
                hazard(
                        "nearly-grey",
                        Colors.of(ColorModel.RGB, 200 / 255.0, 200 / 255.0, 201 / 255.0),
                        DEGRADED,
                        DEGRADED,
                        EXACT),
                hazard("black", Colors.of(ColorModel.RGB, 0, 0, 0), WRONG, EXACT, EXACT),
                hazard("blackest", Colors.of(ColorModel.RGB, 1e-18, 0, 0), WRONG, WRONG, EXACT),
                hazard("white", Colors.of(ColorModel.CMY, 0, 0, 0), WRONG, EXACT, EXACT));
    }

    private static List<Hazard<Colors>> ranges() {
        return List.of(
                hazard(
                        "brighter-than-white",
                        Colors.of(ColorModel.RGB, 1.2, 0.5, 0.5),
                        WRONG,
                        REFUSED,
                        REFUSED),
                hazard(
                        "too-dark-for-digits",
                        Colors.of(ColorModel.HSV, 20, 0.3, 1e-320),
                        WRONG,
                        WRONG,
                        REFUSED),
                hazard(
                        "outside-the-cube",
                        Colors.of(ColorModel.HVS, 0, 1.7, 0.8),
                        REFUSED,
                        REFUSED,
                        REFUSED));
    }

    private static Hazard<Colors> hazard(
            String name,
            Colors colors,
            Verdict.Kind textbook,
            Verdict.Kind eightBit,
            Verdict.Kind formula) {
        return new Hazard<>(
                name,
                colors,
                Map.of("formula-textbook", textbook, "eight-bit", eightBit, "formula", formula));
    }
}
