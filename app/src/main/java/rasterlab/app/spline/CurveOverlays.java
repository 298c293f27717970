package rasterlab.app.spline;

/**
 * The overlays that are drawn beside curve and polyline.
 *
 * @param construction de Casteljau's triangle at t
 * @param comb the curvature along the curve
 * @param hull the convex hulls of the control points
 */
public record CurveOverlays(boolean construction, boolean comb, boolean hull) {
    CurveOverlays withConstruction(boolean shown) {
        return new CurveOverlays(shown, comb, hull);
    }

    CurveOverlays withComb(boolean shown) {
        return new CurveOverlays(construction, shown, hull);
    }

    CurveOverlays withHull(boolean shown) {
        return new CurveOverlays(construction, comb, shown);
    }
}
