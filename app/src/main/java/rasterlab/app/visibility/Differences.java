package rasterlab.app.visibility;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PictureMaker;

/** What both pictures have wrong beside the exact one. */
record Differences(Compared first, Optional<Compared> second) {
    /** Empty where a method refuses the scene. */
    static Optional<Differences> of(Frame frame, PictureMaker maker, BooleanSupplier cancelled) {
        try {
            return Optional.of(
                    new Differences(
                            Compared.of(frame.first(), maker, cancelled),
                            frame.second().map(request -> Compared.of(request, maker, cancelled))));
        } catch (IllegalArgumentException refused) {
            return Optional.empty(); // The picture says why.
        }
    }
}
