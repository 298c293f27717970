package rasterlab.tests.bench.pipeline;

import org.lwjgl.opengl.GL11C;
import rasterlab.engine.scene.VertexQuantity;

/** A torus and all that OpenGL needs to draw it. */
final class GlTorus implements AutoCloseable {
    private final TorusLook look;
    private final GlTarget target;
    private final GlProgram program;
    private final GlTexture texture;
    private final GlMesh mesh;

    GlTorus(TorusScene scene, TorusLook look) {
        this.look = look;
        target = new GlTarget(scene.width(), scene.height());
        program = look.program();
        texture = look.glTexture();
        boolean sorted = look == TorusLook.GLASS;
        mesh = new GlMesh(sorted ? scene.farthestFirst() : scene.mesh(), VertexQuantity.NORMAL_X);
        program.use(scene.toEye(), scene.toClip());
    }

    /** Clears, draws and waits for the end. */
    void draw() {
        target.clear(TorusScene.BACKGROUND);
        look.begin();
        texture.bind();
        mesh.draw();
        look.end();
        target.forgetDepths();
        GL11C.glFinish();
    }

    int[] read() {
        return target.read();
    }

    @Override
    public void close() {
        mesh.close();
        texture.close();
        program.close();
        target.close();
    }
}
