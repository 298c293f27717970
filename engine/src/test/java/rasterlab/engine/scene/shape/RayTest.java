package rasterlab.engine.scene.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.geometry.Vector;

class RayTest {
    private static final double NOTHING = Double.POSITIVE_INFINITY;

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void meetsAt(double t, SceneShape shape, double... line) {
        var ray = new Ray();
        ray.aim(line[0], line[1], line[2], line[3], line[4], line[5], 0);
        shape.meet(ray);
        assertEquals(t, ray.t(), 1e-13);
    }

    static Stream<Arguments> mistakes() {
        SceneShape sphere = new Sphere(1);
        SceneShape tube = Cylinder.open(1, 4);
        SceneShape can = Cylinder.closed(1, 4);
        SceneShape torus = new Torus(2, 0.5);
        SceneShape cube = new Cube(2);
        SceneShape spindle = Shapes.spindle();
        SceneShape vase = Revolution.vase();
        SceneShape quad = Quad.whole(new Vector(0, 0, 0), new Vector(1, 0, 0), new Vector(0, 1, 0));
        SceneShape egg = new Placed(sphere, new Matrix4d().translate(0, 0, 5).scale(1, 1, 3));
        return Stream.of(
                met("the far side of a sphere is taken", 2, sphere, -3, 0, 0, 1, 0, 0),
                met("from inside a sphere nothing is seen", 1, sphere, 0, 0, 0, 1, 0, 0),
                met("a sphere behind the eye is seen", NOTHING, sphere, 3, 0, 0, 1, 0, 0),
                met("t is counted in world units", 1, sphere, -3, 0, 0, 2, 0, 0),
                met("a touching ray misses the sphere", 3, sphere, -3, 1, 0, 1, 0, 0),
                met("a passing ray touches the sphere", NOTHING, sphere, -3, 1.0001, 0, 1, 0, 0),
                met("a tube's far inside is not seen", 1, tube, 0, 0, 0, 0, 1, 0),
                met("a tube is closed", NOTHING, tube, 0, 0, -9, 0, 0, 1),
                met("the near side hides a tube's inside", 4, tube, -3, 0, 4, 1, 0, -0.75),
                met("a ray along the side of a tube meets it", NOTHING, tube, 1, 0, -9, 0, 0, 1),
                met("a tube goes on beyond its end", NOTHING, tube, -3, 0, 2.1, 1, 0, 0),
                met("a ray down the axis misses the lid", 7, can, 0, 0, 9, 0, 0, -1),
                met("the lid is as wide as the world", NOTHING, can, 1.1, 0, 9, 0, 0, -1),
                met("from inside the lid is not seen", 2, can, 0.5, 0, 0, 0, 0, 1),
                met("a ray slips in at the rim", 1, can, 2, 0, 3, -1, 0, -1),
                met("the hole of the torus is filled", NOTHING, torus, 0, 0, 9, 0, 0, -1),
                met("a ray in the torus's plane misses", 0.5, torus, -3, 0, 0, 1, 0, 0),
                met("the torus's inner side is not seen", 1.5, torus, 0, 0, 0, 0, 1, 0),
                met("from inside the tube nothing is seen", 0.5, torus, 2, 0, 0, 0, 0, 1),
                met("a ray on the torus's top misses it", 3, torus, -3, 2, 0.5, 1, 0, 0),
                met("a ray at the torus's equator misses it", 3, torus, 2.5, -3, 0, 0, 1, 0),
                met("a ray at the torus's throat misses it", 3, torus, 1.5, 0, -3, 0, 0, 1),
                met("a ray along a cube's edge line", 1, cube, -2, 0, 0, 1, 0, 0),
                met("from inside a cube nothing is seen", 1, cube, 0, 0, 0, 0, 0, -1),
                met("a ray in a cube's face misses", 1, cube, -2, 1, 0, 1, 0, 0),
                met("a ray past a cube's face meets", NOTHING, cube, -2, 1.01, 0, 1, 0, 0),
                met("a slanting ray past a cube meets it", NOTHING, cube, 0, 3, 0, 1, -1, 0),
                met("a ray at a cube's corner misses", 2, cube, -3, -3, -3, 1, 1, 1),
                met("a spindle's tip lets rays in", 1, spindle, 0, 0, 3, 0, 0, -1),
                met("a level ray misses the spindle's knot", 2, spindle, -3, 0, 0, 1, 0, 0),
                met("a slanting ray misses the spindle's knot", 1, spindle, 2, 0, 1, -1, 0, -1),
                met("a quad has no right side", NOTHING, quad, 1.1, 0, 5, 0, 0, -1),
                met("a quad has no lower side", NOTHING, quad, 0, -1.1, 5, 0, 0, -1),
                met("a quad's corner is left out", 5, quad, 1, 1, 5, 0, 0, -1),
                met("a quad is not seen from behind", 5, quad, 0.5, 0, -5, 0, 0, 1),
                met("a placed shape is met where it was", 7, egg, 0, 0, 9 + 6, 0, 0, -1),
                met("stretching changes t", 3.5, egg, 0, 0, 9 + 6, 0, 0, -2),
                met("the vase has a lid", 325, vase, 0, 0, 200, 0, 0, -1),
                met("the vase has no bottom", 75, vase, 0, 0, -200, 0, 0, 1),
                met("from inside the vase nothing is seen", 94, vase, 0, 0, -50, 0, -1, 0));
    }

    private static Arguments met(String mistake, double t, SceneShape shape, double... line) {
        return argumentSet(mistake, t, shape, line);
    }

    @ParameterizedTest(name = "{argumentSetName} meets a ray elsewhere than at the point aimed at")
    @MethodSource("rasterlab.engine.scene.shape.Shapes#all")
    void normalsAimedBackMeetTheirPoint(SceneShape shape) {
        var ray = new Ray();
        var point = new SurfacePoint();
        for (Patch patch : shape.patches())
            for (int i = 0; i < 30; i++)
                for (int j = 0; j < 20; j++) {
                    patch.at(
                            patch.u().between(i, i + 1, 30),
                            patch.v().between(j, j + 1, 20),
                            point);
                    for (int side = -1; side <= 1; side += 2) {
                        aimAt(ray, point, side * 0.01);
                        shape.meet(ray);
                        assertEquals(0.01, ray.t(), 1e-12, patch + " " + side);
                        assertSame(point, ray.point());
                        assertEquals(side < 0, ray.fromInside());
                    }
                }
    }

    private static void aimAt(Ray ray, SurfacePoint p, double distance) {
        double way = -Math.signum(distance);
        ray.aim(
                p.x + distance * p.normalX,
                p.y + distance * p.normalY,
                p.z + distance * p.normalZ,
                way * p.normalX,
                way * p.normalY,
                way * p.normalZ,
                0);
    }

    private static void assertSame(SurfacePoint expected, SurfacePoint actual) {
        assertEquals(expected.normalX, actual.normalX, 1e-11, "normal x");
        assertEquals(expected.normalY, actual.normalY, 1e-11, "normal y");
        assertEquals(expected.normalZ, actual.normalZ, 1e-11, "normal z");
        assertEquals(expected.s, actual.s, 1e-11, "s");
        assertEquals(expected.t, actual.t, 1e-11, "t");
    }

    @Test
    @DisplayName("a shape behind the nearest one is taken")
    void nearestOfTwoStays() {
        var ray = new Ray();
        ray.aim(-5, 0, 0, 1, 0, 0, 0);
        new Sphere(2).meet(ray);
        new Sphere(1).meet(ray);
        assertEquals(3, ray.t());
        new Sphere(3).meet(ray);
        assertEquals(2, ray.t());
        ray.aim(-5, 0, 0, -1, 0, 0, 0);
        assertEquals(Double.POSITIVE_INFINITY, ray.t());
    }

    @Test
    @DisplayName("the ray stays turned behind a placed shape")
    void placedShapesLeaveTheRayAsItWas() {
        var ray = new Ray();
        ray.aim(-5, 0, 0, 1, 0, 0, 0);
        new Placed(new Sphere(1), new Matrix4d().translate(9, 0, 0)).meet(ray);
        new Sphere(1).meet(ray);
        assertEquals(4, ray.t());
    }

    @ParameterizedTest(name = "the tip met from z = {0} has no normal")
    @ValueSource(ints = {-5, 5})
    void tipsLookAlongTheAxis(int z) {
        var ray = new Ray();
        ray.aim(0, 0, z, 0, 0, -Math.signum(z), 0);
        Shapes.spindle().meet(ray);
        assertEquals(Math.signum(z), ray.point().normalZ());
    }

    @Test
    @DisplayName("what lies before the least t is taken")
    void leastIsKept() {
        var ray = new Ray();
        ray.aim(-5, 0, 0, 1, 0, 0, 4);
        new Sphere(1).meet(ray);
        assertEquals(6, ray.t());
        assertTrue(ray.fromInside());
    }

    @Test
    @DisplayName("a spline below 0 turns the surface inside out")
    void refusesNegativeRadii() {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                new Revolution(
                                        new double[] {0, 1, 2, 3},
                                        new double[] {9, 0.1, 0.1, 9},
                                        SplineEnds.natural(),
                                        false,
                                        false));
        assertTrue(
                refusal.getMessage().startsWith("profile's spline must stay above 0, at z = 1.5"),
                refusal.getMessage());
    }
}
