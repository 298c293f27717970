package rasterlab.tests.bench.pipeline;

import static org.lwjgl.opengl.GL30C.*;

import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/** A mesh in OpenGL's own memory: positions, and normals or colours beside them. */
final class GlMesh implements AutoCloseable {
    private final int array = glGenVertexArrays();
    private final int vertices = glGenBuffers();
    private final int triangles = glGenBuffers();
    private final int count;

    /**
     * @param second the first of the three quantities that the programs call normal
     */
    GlMesh(TriangleMesh mesh, VertexQuantity second) {
        count = mesh.triangles().length;
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, vertices);
        glBufferData(GL_ARRAY_BUFFER, interleaved(mesh, second), GL_STATIC_DRAW);
        for (int k = 0; k < 2; k++) {
            glVertexAttribPointer(k, 3, GL_FLOAT, false, 6 * Float.BYTES, 3L * k * Float.BYTES);
            glEnableVertexAttribArray(k);
        }
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles(), GL_STATIC_DRAW);
    }

    private static float[] interleaved(TriangleMesh mesh, VertexQuantity second) {
        float[] all = new float[6 * mesh.vertexCount()];
        for (int k = 0; k < 6; k++) {
            int first = k < 3 ? VertexQuantity.X.ordinal() : second.ordinal() - 3;
            float[] values = mesh.values(VertexQuantity.values()[first + k]);
            for (int v = 0; v < values.length; v++) all[6 * v + k] = values[v];
        }
        return all;
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
