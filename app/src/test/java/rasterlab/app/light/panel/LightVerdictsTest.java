package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.light.LightHazard;
import rasterlab.engine.study.Verdict;

class LightVerdictsTest {
    @Test
    @DisplayName("means of a cube's normals are called right, or the surface's own wrong")
    void judgesNormalsByTheSurface() {
        for (LightHazard hazard : List.of(LightHazard.ROUNDED_CUBE, LightHazard.CUT_CUBE))
            assertEquals(
                    Map.of(
                            "own", Verdict.Kind.EXACT,
                            "plain", Verdict.Kind.WRONG,
                            "area", Verdict.Kind.WRONG,
                            "angle", Verdict.Kind.WRONG),
                    LightVerdicts.ofNormals(hazard),
                    hazard.code());
    }

    @Test
    @DisplayName("normals are judged where a shading fails")
    void onlyCubesJudgeNormals() {
        assertEquals(
                List.of(LightHazard.ROUNDED_CUBE, LightHazard.CUT_CUBE),
                Stream.of(LightHazard.values()).filter(LightHazard::ofNormals).toList());
    }

    @Test
    @DisplayName("a colour has no verdict by its topic, or every colour the same")
    void judgesColorsByTheirTopic() {
        assertEquals(
                Map.of(
                        "formula", Verdict.Kind.EXACT,
                        "formula-textbook", Verdict.Kind.WRONG,
                        "eight-bit", Verdict.Kind.DEGRADED),
                LightVerdicts.ofColor(new double[] {0.5, 0.5, 0.5}));
        assertEquals(
                Map.of(
                        "formula", Verdict.Kind.EXACT,
                        "formula-textbook", Verdict.Kind.EXACT,
                        "eight-bit", Verdict.Kind.WRONG),
                LightVerdicts.ofColor(new double[] {0.02, 0.01, 0.09}));
    }
}
