package rasterlab.engine.texture.mapping;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Rows along which saved divisions or digits show. */
final class MappingHazards {
    private MappingHazards() {}

    static List<Hazard<TexturedSpan>> all() {
        return List.of(
                hazard(
                        "parallel",
                        new TexturedSpan(0, 0.25, 4, 1, 0.25, 4, 200),
                        EXACT,
                        EXACT,
                        DEGRADED),
                hazard(
                        "both-ends",
                        new TexturedSpan(0.25, 0.5, 4, 0.75, 1, 4, 3),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard("s-is-not-t", new TexturedSpan(1, 0, 2, 0, 0.5, 2, 5), EXACT, EXACT, EXACT),
                hazard("floor", new TexturedSpan(0, 0, 2, 0.5, 1, 10, 300), WRONG, WRONG, DEGRADED),
                hazard(
                        "at-the-near-plane",
                        new TexturedSpan(0, 0, 0.01, 1, 1, 10, 300),
                        WRONG,
                        WRONG,
                        DEGRADED),
                hazard("long-row", new TexturedSpan(0, 0, 1, 8, 8, 50, 8192), WRONG, WRONG, WRONG),
                hazard(
                        "single-pixel",
                        new TexturedSpan(0.5, 0.25, 1, 0.75, 1, 2, 1),
                        EXACT,
                        EXACT,
                        EXACT));
    }

    private static Hazard<TexturedSpan> hazard(
            String name,
            TexturedSpan span,
            Verdict.Kind affine,
            Verdict.Kind pieces,
            Verdict.Kind stepped) {
        return new Hazard<>(
                name,
                span,
                Map.of(
                        "affine",
                        affine,
                        "affine-16",
                        pieces,
                        "stepped-float",
                        stepped,
                        "perspective",
                        EXACT,
                        "affine-textbook",
                        affine));
    }
}
