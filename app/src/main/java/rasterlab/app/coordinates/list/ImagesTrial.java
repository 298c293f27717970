package rasterlab.app.coordinates.list;

import java.util.Optional;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;

/**
 * A topic whose outputs are points of space and nothing else.
 *
 * @param <C> contract of the topic's methods
 * @param <I> its input
 */
abstract class ImagesTrial<C, I> extends TrialKind<C, I, Images> {
    ImagesTrial(Topic<C, I, Images> topic) {
        super(topic);
    }

    @Override
    final Images images(Images output) {
        return output;
    }

    @Override
    final Optional<double[]> h(Images output) {
        return Optional.empty();
    }

    @Override
    final Images outputOf(Images output, int point) {
        return new Images(xyz(output.coordinates(), point), 3);
    }
}
