package rasterlab.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.scene.catalogue.Scenes;

class SmoothedMeshTest {
    private static VertexNormals method(String name) {
        return new NormalsTopic().method(name).implementation();
    }

    /** The faces, each with vertices of its own: every edge is a seam. */
    private static Mesh apart(Mesh mesh) {
        var xyz = new double[3 * mesh.totalCorners()];
        var faces = new int[mesh.faceCount()][];
        int vertex = 0;
        for (int f = 0; f < faces.length; f++) {
            faces[f] = new int[mesh.cornerCount(f)];
            for (int k = 0; k < faces[f].length; k++, vertex++) {
                int v = mesh.corner(f, k);
                xyz[3 * vertex] = mesh.x(v);
                xyz[3 * vertex + 1] = mesh.y(v);
                xyz[3 * vertex + 2] = mesh.z(v);
                faces[f][k] = vertex;
            }
        }
        return new Mesh(xyz, faces);
    }

    @Test
    void seamOfASphereIsNotSeen() {
        Mesh sphere = SmoothedMesh.of(apart(Scenes.named("sphere", 24).mesh()), method("angle"));
        for (int f = 0; f < sphere.faceCount(); f++)
            for (int k = 0; k < sphere.cornerCount(f); k++) {
                int v = sphere.corner(f, k);
                double along =
                        sphere.cornerNormal(f, k, 0) * sphere.x(v)
                                + sphere.cornerNormal(f, k, 1) * sphere.y(v)
                                + sphere.cornerNormal(f, k, 2) * sphere.z(v);
                assertTrue(along > 99.5, "face " + f + ", corner " + k + ": " + along);
            }
    }

    @Test
    void cornersOfACubePointAlongItsDiagonals() {
        Mesh cube = SmoothedMesh.of(Scenes.named("cube").mesh(), method("angle"));
        for (int k = 0; k < 4; k++)
            for (int axis = 0; axis < 3; axis++)
                assertEquals(1 / Math.sqrt(3), Math.abs(cube.cornerNormal(0, k, axis)), 1e-9);
    }
}
