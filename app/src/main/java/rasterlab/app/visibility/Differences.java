package rasterlab.app.visibility;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.engine.pipeline.RenderRequest;

/** The faults of both pictures beside the exact one; each is told of without the other. */
record Differences(PictureOutcome first, Optional<PictureOutcome> second) {
    /**
     * One picture, compared or refused.
     *
     * @param compared empty where the method refuses the scene
     * @param refusal what it said then, in English; empty where the picture is compared
     */
    record PictureOutcome(Optional<Compared> compared, Optional<String> refusal) {
        private static PictureOutcome of(
                RenderRequest request, PictureMaker maker, BooleanSupplier cancelled) {
            try {
                return new PictureOutcome(
                        Optional.of(Compared.of(request, maker, cancelled)), Optional.empty());
            } catch (IllegalArgumentException refused) {
                return new PictureOutcome(Optional.empty(), Optional.of(refused.getMessage()));
            }
        }
    }

    static Differences of(Frame frame, PictureMaker maker, BooleanSupplier cancelled) {
        return new Differences(
                PictureOutcome.of(frame.first(), maker, cancelled),
                frame.second().map(request -> PictureOutcome.of(request, maker, cancelled)));
    }
}
