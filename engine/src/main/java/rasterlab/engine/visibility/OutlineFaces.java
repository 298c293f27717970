package rasterlab.engine.visibility;

import rasterlab.engine.scene.Mesh;

/**
 * The faces at a body's outline, on a picture of it.
 *
 * <p>There fronts and backs are side by side, and the surface runs along the line of sight. Places
 * on a picture are rounded to 1/256 pixel, so that a back comes out nearer than its front now and
 * then, or just as near, and what is drawn first is seen. Whoever leaves faces out, or draws some
 * before others, leaves these as they are. They are the faces that share a corner with one that
 * turns its other side to the eye, and those that are seen nearly from the side: on a ball of r
 * pixels the first of the others is r·φ²/2 pixels inside of the outline, φ being {@link #ASIDE},
 * and its front 2·r·φ pixels nearer than its back.
 */
public final class OutlineFaces {
    /** The angle, in radians, below which a face counts as seen from the side. */
    private static final double ASIDE = 1.0 / 16;

    private final ViewedMesh view;
    private final double room;
    private final boolean[] at;

    private OutlineFaces(ViewedMesh view, double turn) {
        this.view = view;
        room = Math.sin(Math.min(Math.PI / 2, turn));
        Mesh mesh = view.mesh();
        double most = Math.sin(Math.min(Math.PI / 2, turn + ASIDE));
        at = new boolean[mesh.faceCount()];
        var ofFront = new boolean[mesh.vertexCount()];
        var ofBack = new boolean[mesh.vertexCount()];
        for (int f = 0; f < at.length; f++) {
            double behind = behind(f);
            at[f] = Math.abs(behind) <= most;
            if (front(behind)) mark(f, ofFront);
            if (back(behind)) mark(f, ofBack);
        }
        for (int f = 0; f < at.length; f++)
            for (int k = 0; k < mesh.cornerCount(f) && !at[f]; k++)
                at[f] = ofFront[mesh.corner(f, k)] && ofBack[mesh.corner(f, k)];
    }

    /** Tells of each face whether it is at the outline. */
    public static boolean[] faces(ViewedMesh view) {
        return new OutlineFaces(view, 0).at;
    }

    /**
     * The faces that a picture of a closed body needs: all fronts, and what is at the outline.
     *
     * @param turn radians by which the direction to the eye may still turn, at least 0
     */
    public static boolean[] andFronts(ViewedMesh view, double turn) {
        var outline = new OutlineFaces(view, turn);
        for (int f = 0; f < outline.at.length; f++)
            outline.at[f] |= outline.front(outline.behind(f));
        return outline.at;
    }

    private void mark(int face, boolean[] vertices) {
        Mesh mesh = view.mesh();
        for (int k = 0; k < mesh.cornerCount(face); k++) vertices[mesh.corner(face, k)] = true;
    }

    private boolean front(double behind) {
        return behind <= room;
    }

    private boolean back(double behind) {
        return behind > -room;
    }

    /** The sine of the angle by which a face has turned its back to the eye. */
    private double behind(int face) {
        if (!view.transform().central()) return view.eyeNormal(face, 2);
        int v = view.mesh().corner(face, 0);
        double x = view.eyeX(v);
        double y = view.eyeY(v);
        double z = view.eyeZ(v);
        return view.planeOffset(face) / Math.sqrt(x * x + y * y + z * z);
    }
}
