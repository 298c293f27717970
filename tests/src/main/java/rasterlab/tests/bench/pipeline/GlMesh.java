package rasterlab.tests.bench.pipeline;

import static org.lwjgl.opengl.GL30C.*;

import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/** A mesh in OpenGL's own memory: positions, normals or colours, texture coordinates. */
final class GlMesh implements AutoCloseable {
    /** Numbers of each vertex. */
    private static final int NUMBERS = 8;

    private final int array = glGenVertexArrays();
    private final int vertices = glGenBuffers();
    private final int triangles = glGenBuffers();
    private final int count;

    /**
     * @param second the first of the three quantities that the programs call normal; beside normals
     *     the mesh has texture coordinates
     */
    GlMesh(TriangleMesh mesh, VertexQuantity second) {
        count = mesh.triangles().length;
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, vertices);
        glBufferData(GL_ARRAY_BUFFER, interleaved(mesh, second), GL_STATIC_DRAW);
        for (int k = 0; k < 3; k++) {
            int numbers = k < 2 ? 3 : 2;
            long at = 3L * k * Float.BYTES;
            glVertexAttribPointer(k, numbers, GL_FLOAT, false, NUMBERS * Float.BYTES, at);
            glEnableVertexAttribArray(k);
        }
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles(), GL_STATIC_DRAW);
    }

    private static float[] interleaved(TriangleMesh mesh, VertexQuantity second) {
        float[] all = new float[NUMBERS * mesh.vertexCount()];
        put(mesh, VertexQuantity.X, 3, all, 0);
        put(mesh, second, 3, all, 3);
        if (second == VertexQuantity.NORMAL_X) put(mesh, VertexQuantity.TEXTURE_S, 2, all, 6);
        return all;
    }

    private static void put(
            TriangleMesh mesh, VertexQuantity first, int count, float[] all, int at) {
        for (int k = 0; k < count; k++) {
            float[] values = mesh.values(VertexQuantity.values()[first.ordinal() + k]);
            for (int v = 0; v < values.length; v++) all[NUMBERS * v + at + k] = values[v];
        }
    }

    void draw() {
        glBindVertexArray(array);
        glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, 0);
    }

    @Override
    public void close() {
        glDeleteVertexArrays(array);
        glDeleteBuffers(vertices);
        glDeleteBuffers(triangles);
    }
}
