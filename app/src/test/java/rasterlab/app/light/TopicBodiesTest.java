package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.contract.ColorModel;
import rasterlab.contract.LitPoint;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.color.Colors;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.TriangleSurface;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

class TopicBodiesTest {
    private static <I> I input(List<Hazard<I>> hazards, String name) {
        return hazards.stream()
                .filter(one -> one.name().equals(name))
                .findFirst()
                .orElseThrow()
                .input();
    }

    private static LitPoints points(String hazard) {
        return input(new ShadeTopic().hazards(), hazard);
    }

    @Test
    void pointIsAsFarFromTheSpotAndItsAxisAsTheHazards() {
        LitPoint point = points("outside-the-cone").points().get(0);
        SpotPlace place = SpotPlace.of(point).orElseThrow();
        var toPoint = new Vector3d(place.x() - place.lampX(), 0, -place.lampZ());
        var axis = new Vector3d(-place.lampX(), 0, -place.lampZ());
        assertEquals(point.distance(), toPoint.length(), 1e-12);
        double[] l = point.toLight();
        double[] d = point.light().cone().direction();
        var away = new Vector3d(-l[0], -l[1], -l[2]);
        assertEquals(away.angle(new Vector3d(d[0], d[1], d[2])), toPoint.angle(axis), 1e-9);
        LightChoice shown =
                TopicBodies.shown("shade/outside-the-cone", points("outside-the-cone"), "");
        assertEquals(Lamp.LampKind.SPOT, shown.lamp().kind());
        assertEquals(point.light().cone().cutoff(), shown.lamp().cutoff());
    }

    @ParameterizedTest
    @ValueSource(strings = {"interpolated-normal", "huge-normal", "tiny-normal"})
    void normalKeepsItsDirection(String hazard) {
        double[] n = points(hazard).points().get(0).normal();
        double size = Math.max(Math.abs(n[0]), Math.abs(n[2]));
        var right = new Vector3d(n[0] / size, n[1] / size, n[2] / size).normalize();
        Mesh mesh = TopicMesh.of(points(hazard), "").mesh();
        for (int axis = 0; axis < 3; axis++)
            assertEquals(right.get(axis), mesh.cornerNormal(0, 0, axis), 1e-12);
    }

    @Test
    void methodsOwnNormalsAreShownWhereTheyHaveADirection() {
        TriangleSurface roof = input(new NormalsTopic().hazards(), "roof-with-a-long-side");
        TopicMesh own = TopicMesh.of(roof, "plain-textbook");
        assertEquals(
                ShownDifference.ShownDifferenceKind.NORMALS_LENGTHENED,
                own.differences().get(0).kind());
        assertTrue(own.mesh().hasNormals());
        assertEquals(0, own.mesh().cornerNormal(0, 0, 0), 1e-12);
        assertEquals(1, own.mesh().cornerNormal(0, 0, 2), 1e-12);
        TriangleSurface tiny = input(new NormalsTopic().hazards(), "tiny-faces");
        TopicMesh faces = TopicMesh.of(tiny, "plain-textbook");
        assertEquals(
                List.of(
                        ShownDifference.ShownDifferenceKind.SCALED,
                        ShownDifference.ShownDifferenceKind.FACE_NORMAL),
                faces.differences().stream().map(ShownDifference::kind).toList());
        assertEquals(faces.mesh().normalZ(0), faces.mesh().cornerNormal(0, 1, 2));
    }

    @Test
    void colorOutsideTheCubeIsBroughtToItsNearestPlace() {
        Colors bright = input(new ColorTopic().hazards(), "brighter-than-white");
        ColorChoice cut = ColorChoice.first().with(bright, "formula");
        assertTrue(cut.outside());
        assertEquals(List.of(1.0, 0.5, 0.5), cut.components());
        Colors beyond = input(new ColorTopic().hazards(), "outside-the-cube");
        ColorChoice paled = ColorChoice.first().with(beyond, "formula");
        assertEquals(ColorModel.HVS, paled.model());
        assertEquals(List.of(0.0, 1.7), paled.components().subList(0, 2));
        assertEquals(1, paled.in(ColorModel.RGB)[0], 1e-9);
    }

    @Test
    void noteGoesWithTheNextChange() {
        var model = new LightLabModel(Runnable::run, failure -> {});
        var verdict = new Verdict(Verdict.Kind.REFUSED, Deviation.NONE, "no");
        model.tell(
                new HazardNote(
                        "black",
                        "formula",
                        verdict,
                        List.of(
                                ShownDifference.of(
                                        ShownDifference.ShownDifferenceKind.COLOR_CUT))));
        assertEquals("black", model.state().note().orElseThrow().hazard());
        model.drawNormals(true);
        assertFalse(model.state().note().isPresent());
        model.close();
    }

    @Test
    void floorLiesAroundAPointWithALampInIt() {
        Mesh floor = TopicMesh.of(points("light-in-the-point"), "").mesh();
        var normals = new double[] {floor.normalX(0), floor.normalY(0), floor.normalZ(0)};
        assertArrayEquals(new double[] {0, 0, 1}, normals, 1e-12);
        assertTrue(floor.faceCount() > 100, floor.faceCount() + " faces");
    }
}
