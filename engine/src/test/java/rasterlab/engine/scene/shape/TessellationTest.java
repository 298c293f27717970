package rasterlab.engine.scene.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.HashSet;
import java.util.Set;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.Vase;
import rasterlab.engine.scene.VertexQuantity;

class TessellationTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(Executable mistake, String message) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, mistake).getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "a torus without a hole is let in",
                        (Executable) () -> new Torus(1, 1),
                        "torus needs 0 < minor < major < ∞, got minor 1.0, major 1.0"),
                argumentSet(
                        "two sides go round",
                        (Executable) () -> triangles(new Sphere(1), 2, 8),
                        "steps of u must be at least 3, got 2"),
                argumentSet(
                        "a sphere has no width",
                        (Executable) () -> triangles(new Sphere(1), 8, 1),
                        "steps of v must be at least 2, got 1"),
                argumentSet(
                        "more triangles than an array holds are begun",
                        (Executable) () -> triangles(new Sphere(1), 100_000, 100_000),
                        "100000×100000 steps make 20000000000 triangles, at most 67108864 are"
                                + " allowed"),
                argumentSet(
                        "a mirror image is placed",
                        (Executable)
                                () -> new Placed(new Sphere(1), new Matrix4d().scaling(-1, 1, 1)),
                        "toWorld must be affine with a finite determinant above 0, got -1.0 and\n"
                                + new Matrix4d().scaling(-1, 1, 1)),
                argumentSet(
                        "0 is a radius",
                        (Executable) () -> new Sphere(0),
                        "sphere's radius must be from 1.0E-30 to 1.0E30, got 0.0"),
                argumentSet(
                        "NaN is a radius",
                        (Executable) () -> new Sphere(Double.NaN),
                        "sphere's radius must be from 1.0E-30 to 1.0E30, got NaN"));
    }

    /** Compares the torus with the formula that it was made by before there were other shapes. */
    @Test
    @DisplayName("the torus moves by a unit of the last place")
    void torusKeepsItsBits() {
        int rings = 50;
        int sides = 20;
        var mesh = triangles(new Torus(1, 0.45), rings, sides);
        for (int i = 0, at = 0; i <= rings; i++) {
            double u = 2 * Math.PI * (i % rings) / rings;
            for (int j = 0; j <= sides; j++, at++) {
                double v = 2 * Math.PI * (j % sides) / sides;
                double reach = 1 + 0.45 * Math.cos(v);
                same(reach * Math.cos(u), mesh, VertexQuantity.X, at);
                same(reach * Math.sin(u), mesh, VertexQuantity.Y, at);
                same(0.45 * Math.sin(v), mesh, VertexQuantity.Z, at);
                same(Math.cos(v) * Math.cos(u), mesh, VertexQuantity.NORMAL_X, at);
                same(Math.cos(v) * Math.sin(u), mesh, VertexQuantity.NORMAL_Y, at);
                same(Math.sin(v), mesh, VertexQuantity.NORMAL_Z, at);
                same((float) i / rings, mesh, VertexQuantity.TEXTURE_S, at);
                same((float) j / sides, mesh, VertexQuantity.TEXTURE_T, at);
            }
        }
        assertEquals(2 * rings * sides, mesh.triangleCount());
        assertEquals(sides + 2, mesh.triangles()[2]);
    }

    private static TriangleMesh triangles(SceneShape shape, int uSteps, int vSteps) {
        return new TriangleGrid(new Tessellation(shape, uSteps, vSteps)).mesh();
    }

    private static void same(double expected, TriangleMesh mesh, VertexQuantity of, int at) {
        assertEquals(
                Float.floatToRawIntBits((float) expected),
                Float.floatToRawIntBits(mesh.values(of)[at]),
                () -> of + " of vertex " + at);
    }

    /** Each edge of a closed surface is there once in each direction. */
    @ParameterizedTest(name = "{argumentSetName} has a crack")
    @MethodSource("rasterlab.engine.scene.shape.Shapes#closed")
    void trianglesClose(SceneShape shape) {
        for (int steps : new int[] {3, 4, 7, 30}) {
            var mesh = triangles(shape, steps, steps);
            var open = new HashSet<String>();
            int[] corners = mesh.triangles();
            for (int i = 0; i < corners.length; i++) {
                int next = corners[i % 3 == 2 ? i - 2 : i + 1];
                pair(open, place(mesh, corners[i]), place(mesh, next));
            }
            assertEquals(Set.of(), open, "edges without a neighbour");
        }
    }

    @ParameterizedTest(name = "faces of the {argumentSetName} do not share their edges")
    @MethodSource("rasterlab.engine.scene.shape.Shapes#closed")
    void facesClose(SceneShape shape) {
        for (int steps : new int[] {3, 7, 30}) {
            Mesh mesh = shape.faces(steps, steps);
            var open = new HashSet<String>();
            for (int f = 0; f < mesh.faceCount(); f++)
                for (int k = 0; k < mesh.cornerCount(f); k++) {
                    int next = mesh.corner(f, (k + 1) % mesh.cornerCount(f));
                    pair(open, mesh.corner(f, k) + ";", next + ";");
                }
            assertEquals(Set.of(), open, "edges without a neighbour");
        }
    }

    private static void pair(Set<String> open, String from, String to) {
        if (!open.remove(to + from)) open.add(from + to);
    }

    private static String place(TriangleMesh mesh, int vertex) {
        return (mesh.values(VertexQuantity.X)[vertex] + 0f)
                + " "
                + (mesh.values(VertexQuantity.Y)[vertex] + 0f)
                + " "
                + (mesh.values(VertexQuantity.Z)[vertex] + 0f)
                + ";";
    }

    @ParameterizedTest(name = "a triangle of the {argumentSetName} is flat as a line or turned")
    @MethodSource("rasterlab.engine.scene.shape.Shapes#all")
    void trianglesFaceTheirNormals(SceneShape shape) {
        var mesh = triangles(shape, 24, 12);
        int[] corners = mesh.triangles();
        for (int i = 0; i < corners.length; i += 3) {
            Vector3 a = new Vector3(mesh, corners[i]);
            Vector3 b = new Vector3(mesh, corners[i + 1]);
            Vector3 c = new Vector3(mesh, corners[i + 2]);
            double[] n = a.crossOfEdges(b, c);
            for (Vector3 corner : new Vector3[] {a, b, c})
                assertTrue(
                        n[0] * corner.nx + n[1] * corner.ny + n[2] * corner.nz > 0,
                        "triangle " + i / 3);
        }
    }

    @ParameterizedTest(name = "the texture of the {argumentSetName} is mirrored")
    @MethodSource("rasterlab.engine.scene.shape.Shapes#all")
    void texturesAreSeenFromTheirFront(SceneShape shape) {
        var mesh = triangles(shape, 24, 12);
        float[] s = mesh.values(VertexQuantity.TEXTURE_S);
        float[] t = mesh.values(VertexQuantity.TEXTURE_T);
        int[] corners = mesh.triangles();
        for (int i = 0; i < corners.length; i += 3) {
            int a = corners[i];
            int b = corners[i + 1];
            int c = corners[i + 2];
            double area = (s[b] - s[a]) * (t[c] - t[a]) - (s[c] - s[a]) * (t[b] - t[a]);
            assertTrue(area > 0, "triangle " + i / 3);
        }
    }

    @Test
    @DisplayName("the texture leans at the poles")
    void polesTakeTheMiddleOfTheTexture() {
        float[] s = triangles(new Sphere(1), 4, 2).values(VertexQuantity.TEXTURE_S);
        assertEquals(0.125f, s[0]);
        assertEquals(0, s[1]);
        assertEquals(0.125f, s[2]);
        assertEquals(0.375f, s[3]);
    }

    private static final class Vector3 {
        private final double x;
        private final double y;
        private final double z;
        private final double nx;
        private final double ny;
        private final double nz;

        Vector3(TriangleMesh mesh, int v) {
            x = mesh.values(VertexQuantity.X)[v];
            y = mesh.values(VertexQuantity.Y)[v];
            z = mesh.values(VertexQuantity.Z)[v];
            nx = mesh.values(VertexQuantity.NORMAL_X)[v];
            ny = mesh.values(VertexQuantity.NORMAL_Y)[v];
            nz = mesh.values(VertexQuantity.NORMAL_Z)[v];
        }

        double[] crossOfEdges(Vector3 b, Vector3 c) {
            double px = b.x - x;
            double py = b.y - y;
            double pz = b.z - z;
            double qx = c.x - x;
            double qy = c.y - y;
            double qz = c.z - z;
            return new double[] {py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx};
        }
    }

    @ParameterizedTest(name = "normals of the {argumentSetName} lean")
    @MethodSource("rasterlab.engine.scene.shape.Shapes#all")
    void normalsStandOnTheSurface(SceneShape shape) {
        for (Patch patch : shape.patches())
            for (int i = 1; i < 40; i++)
                for (int j = 1; j < 20; j++) {
                    double u = patch.u().at(i, 40);
                    double v = patch.v().at(j, 20);
                    assertUpright(patch, u, v);
                }
    }

    private static void assertUpright(Patch patch, double u, double v) {
        double du = (patch.u().to() - patch.u().from()) * 1e-5;
        double dv = (patch.v().to() - patch.v().from()) * 1e-5;
        double[] alongU = difference(at(patch, u - du, v), at(patch, u + du, v));
        double[] alongV = difference(at(patch, u, v - dv), at(patch, u, v + dv));
        SurfacePoint here = at(patch, u, v);
        double[] n = {here.normalX, here.normalY, here.normalZ};
        assertEquals(1, dot(n, n), 1e-15, "length of the normal, squared");
        assertEquals(0, dot(n, alongU) / Math.sqrt(dot(alongU, alongU)), 1e-8);
        assertEquals(0, dot(n, alongV) / Math.sqrt(dot(alongV, alongV)), 1e-8);
    }

    private static SurfacePoint at(Patch patch, double u, double v) {
        var point = new SurfacePoint();
        patch.at(u, v, point);
        return point;
    }

    private static double[] difference(SurfacePoint a, SurfacePoint b) {
        return new double[] {b.x - a.x, b.y - a.y, b.z - a.z};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    @Test
    @DisplayName("the vase's spline misses its parallels")
    void vaseKeepsItsRadii() {
        Mesh smooth = Revolution.vase().faces(Vase.MERIDIANS, Vase.PARALLELS - 1);
        assertEquals(300, smooth.faceCount());
        assertEquals(301, smooth.vertexCount());
        int[] radii = Vase.radii();
        for (int v = 0; v < smooth.vertexCount(); v++) {
            int parallel = (int) Math.round((smooth.z(v) + 125) / 25);
            double radius = Math.hypot(smooth.x(v), smooth.y(v));
            if (radius > 0) assertEquals(radii[parallel], radius, 1e-12, "vertex " + v);
        }
    }
}
