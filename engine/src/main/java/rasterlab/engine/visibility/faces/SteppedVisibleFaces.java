package rasterlab.engine.visibility.faces;

import rasterlab.contract.VisibleFaces;

/** A method that judges face by face and can be watched doing so. */
public interface SteppedVisibleFaces extends VisibleFaces {
    /** A walk that has judged no face yet. */
    FaceWalk walk(Body body);

    /** The meaning of a step's value, and when it means visible. */
    String decision();

    @Override
    default boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside) {
        return drained(new Body(xyz, faces, eye, inside));
    }

    /** All faces of a body, by the walk. */
    default boolean[] drained(Body body) {
        var visible = new boolean[body.faceCount()];
        FaceWalk walk = walk(body);
        while (walk.advance()) visible[walk.face()] = walk.visible();
        return visible;
    }
}
