package rasterlab.engine.pipeline.direct;

import rasterlab.engine.pipeline.direct.Batches.Batch;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;

/** The faces of a scene, packed by finish: what is kept from one picture of it to the next. */
final class PackedScene {
    /**
     * A finish is packed whole unless fewer than one in so many of its faces are drawn together.
     */
    private static final int FEW = 4;

    private final Mesh mesh;
    private final int[] finishOf;
    private final boolean apart;
    private final int[] facesOf;
    private final PackedFaces[] packed;

    /**
     * @param apart whether each face has vertices of its own, because light tells faces apart
     */
    PackedScene(Scene scene, boolean apart) {
        mesh = scene.mesh();
        finishOf = scene.finishOf();
        this.apart = apart;
        facesOf = new int[scene.finishes().size()];
        for (int finish : finishOf) facesOf[finish]++;
        packed = new PackedFaces[facesOf.length];
    }

    /** Whether it holds a scene's faces as asked. */
    boolean holds(Scene scene, boolean facesApart) {
        if (scene.mesh() != mesh || facesApart != apart) return false;
        if (scene.finishes().size() != facesOf.length) return false;
        for (int f = 0; f < finishOf.length; f++)
            if (scene.finishNumber(f) != finishOf[f]) return false;
        return true;
    }

    /** Packed faces among which those of a batch are. */
    PackedFaces with(Batch batch) {
        int finish = batch.finish();
        if (FEW * batch.faces().length < facesOf[finish]) return pack(batch.faces());
        if (packed[finish] == null) packed[finish] = pack(all(finish));
        return packed[finish];
    }

    private PackedFaces pack(int[] faces) {
        return apart ? PackedFaces.apart(mesh, faces) : PackedFaces.shared(mesh, faces);
    }

    private int[] all(int finish) {
        int[] faces = new int[facesOf[finish]];
        int at = 0;
        for (int f = 0; f < finishOf.length; f++) if (finishOf[f] == finish) faces[at++] = f;
        return faces;
    }
}
