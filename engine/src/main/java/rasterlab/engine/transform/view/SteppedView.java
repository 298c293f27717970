package rasterlab.engine.transform.view;

import java.util.List;
import rasterlab.contract.EyeView;

/** A view whose steps can be looked at, one point at a time. */
public interface SteppedView extends EyeView {
    /**
     * The steps that take a point to the eye; the last three give what {@code view} gives.
     *
     * @throws IllegalArgumentException as {@code view} does
     */
    List<ViewStep> steps(double theta, double phi, double rho, double x, double y, double z);
}
