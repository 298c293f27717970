package rasterlab.engine.visibility;

import rasterlab.engine.transform.PictureFit;

/**
 * How near the mesh comes to the eye in the picture: the smallest z in eye space of what lies
 * between the near and the far plane and the four planes through the eye and the picture's sides.
 *
 * <p>Where vertices lie behind the eye, the mesh's own least z says nothing about that.
 */
public final class NearestSeen {
    private final ViewedMesh view;
    private final double[][] sides;
    private EyePolygon from;
    private EyePolygon to;

    private NearestSeen(ViewedMesh view) {
        this.view = view;
        int mostCorners = view.mesh().mostCorners() + 6;
        from = new EyePolygon(mostCorners);
        to = new EyePolygon(mostCorners);
        PictureFit fit = view.fit();
        double distance = view.transform().distance();
        double left = fit.toPlaneX(-1);
        double right = fit.toPlaneX(fit.width());
        double top = fit.toPlaneY(-1);
        double bottom = fit.toPlaneY(fit.height());
        sides =
                new double[][] {
                    {distance, 0, -left}, {-distance, 0, right},
                    {0, -distance, top}, {0, distance, -bottom}
                };
    }

    /**
     * @param view in perspective
     * @return infinite where the picture shows nothing
     */
    public static double of(ViewedMesh view) {
        var search = new NearestSeen(view);
        double least = Double.POSITIVE_INFINITY;
        for (int face = 0; face < view.mesh().faceCount(); face++)
            least = Math.min(least, search.of(face));
        return least;
    }

    private double of(int face) {
        from.size = 0;
        for (int k = 0; k < view.mesh().cornerCount(face); k++) {
            int v = view.mesh().corner(face, k);
            from.add(view.eyeX(v), view.eyeY(v), view.eyeZ(v));
        }
        from.cut(view.near(), 1, to);
        to.cut(view.far(), -1, from);
        for (double[] side : sides) {
            from.cut(side, to);
            EyePolygon cut = to;
            to = from;
            from = cut;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < from.size; k++) least = Math.min(least, from.z[k]);
        return least;
    }
}
