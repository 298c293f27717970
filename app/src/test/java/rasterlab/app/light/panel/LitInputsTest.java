package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.light.Lamp;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.LightLabState;
import rasterlab.app.light.LitBody;
import rasterlab.contract.LitPoint;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.normals.TriangleSurface;
import rasterlab.engine.light.shade.FormulaShader;

/** Inputs of the topics about light that a body, a lamp and an eye of the lab make. */
@Timeout(300)
class LitInputsTest {
    private static final double ROUNDING = 1e-9;

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LightLabModel model = new LightLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private LightLabState drawn() {
        model.resize(150, 180);
        thread.settle(model::settle);
        return model.state();
    }

    /** The lab's first picture with one lamp and nothing cut, so that one input tells all of it. */
    private void useOneLamp() {
        model.choose(choice -> choice.selecting(1).shrunk());
        model.choose(choice -> choice.withLamp(0, choice.lamp().withStrength(0.3)));
    }

    @Test
    void markedPointHasTheLightThatTheInspectorTells() {
        useOneLamp();
        LightLabState state = drawn();
        LitPoint point = LitInputs.point(state).orElseThrow().points().get(0);
        double[] told = state.drawn().orElseThrow().point().orElseThrow().sum();
        double[] lit = new FormulaShader(state.choice().reflection()).intensity(point);
        assertArrayEquals(told, lit, ROUNDING);
    }

    @Test
    void faceOfTheMarkedPointHasThePointsLightThere() {
        useOneLamp();
        LightLabState state = drawn();
        LitPoint point = LitInputs.point(state).orElseThrow().points().get(0);
        FacePoints face = LitInputs.face(state).orElseThrow();
        assertArrayEquals(
                position(state), at(face.face().corners(), face.weights()), 1e-6, "the same place");
        double[] normal = at(face.face().normals(), face.weights());
        double along =
                normal[0] * point.normal()[0]
                        + normal[1] * point.normal()[1]
                        + normal[2] * point.normal()[2];
        double length = Math.hypot(Math.hypot(normal[0], normal[1]), normal[2]);
        assertEquals(1, along / length, 0.01, "the same normal");
    }

    private static double[] position(LightLabState state) {
        return state.drawn().orElseThrow().point().orElseThrow().position();
    }

    private static double[] at(double[] corners, double[] shares) {
        var mean = new double[3];
        for (int i = 0; i < corners.length; i++) mean[i % 3] += shares[i / 3] * corners[i];
        return mean;
    }

    @Test
    void nothingIsHandedInOfAPictureThatIsNotThereYet() {
        assertEquals(Optional.empty(), LitInputs.point(model.state()));
        drawn();
        model.choose(choice -> choice.withAmbient(0.9));
        assertEquals(Optional.empty(), LitInputs.point(model.state()));
    }

    @Test
    void inputStaysItselfUntilItsLampIsMoved() {
        FacePoints given = new FaceTopic().hazards().get(0).input();
        model.show("shade-face", new FaceTopic().hazards().get(0).name(), given, "");
        FacePoints same = LitInputs.face(model.state()).orElseThrow();
        assertArrayEquals(given.face().corners(), same.face().corners());
        assertArrayEquals(given.face().lamp(), same.face().lamp());
        model.choose(choice -> choice.withLamp(0, choice.lamp().moved(7, 8, 9)));
        FacePoints moved = LitInputs.face(model.state()).orElseThrow();
        assertArrayEquals(new double[] {7, 8, 9}, moved.face().lamp());
        assertArrayEquals(given.weights(), moved.weights(), "the points stay");
    }

    @Test
    void sunLightsNoFaceOfTheTopic() {
        useOneLamp();
        model.choose(choice -> choice.withLamp(0, choice.lamp().withKind(Lamp.LampKind.SUN)));
        assertEquals(Optional.empty(), LitInputs.face(drawn()));
    }

    @Test
    void bodyIsCutIntoTrianglesOfItsOwnCorners() {
        model.choose(choice -> choice.with(new LitBody("cube", 12, LitBody.OWN)));
        TriangleSurface cube = LitInputs.body(model.state().choice());
        assertEquals(8 * 3, cube.vertices().length);
        assertEquals(12 * 3, cube.triangles().length);
    }
}
