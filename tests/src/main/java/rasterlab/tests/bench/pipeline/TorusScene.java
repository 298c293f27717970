package rasterlab.tests.bench.pipeline;

import org.joml.Matrix4d;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.shape.Torus;
import rasterlab.engine.transform.GlMatrices;

/**
 * A torus that fills about half of the picture, lit by one distant light with a highlight.
 *
 * @param triangles of the torus, half of them seen from behind
 */
record TorusScene(int triangles, int width, int height) {
    static final int BACKGROUND = 0xFF202020;
    static final int BASE_RGB = 0xE69950;
    static final double AMBIENT = 0.2;
    static final double SPECULAR = 0.5;
    static final int SHININESS = 32;

    static double[] toLight() {
        return new double[] {1 / Math.sqrt(3), 1 / Math.sqrt(3), 1 / Math.sqrt(3)};
    }

    TriangleMesh mesh() {
        return Torus.ofTriangles(1, 0.45, triangles).mesh();
    }

    Matrix4d toEye() {
        return new Matrix4d().translate(0, 0.1, -3.6).rotateX(-0.9).rotateZ(0.4);
    }

    Matrix4d toClip() {
        return GlMatrices.perspective(45, (double) width / height, 1, 10);
    }

    TriangleView view() {
        return new TriangleView(toEye(), toClip());
    }

    DistantLight light() {
        return new DistantLight(toLight(), BASE_RGB, AMBIENT, SPECULAR, SHININESS);
    }

    @Override
    public String toString() {
        return "torus of %,d triangles, %d×%d".formatted(triangles, width, height);
    }
}
