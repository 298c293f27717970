package rasterlab.app.visibility;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.faces.SeenFaces;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.hidden.Visibilities;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.Painting;
import rasterlab.engine.visibility.order.Sight;

/**
 * The user's own program as a method that draws pictures. It is asked once for what a picture
 * shows: the steps and the wrong pixels of the same view are of the same answer.
 */
final class OwnVisibility {
    private static final String FACES = new VisibleFacesTopic().name();

    private OwnVisibility() {}

    /**
     * Draws by the program on that topic; where there is none, it refuses and says how to get one.
     *
     * @param topic {@code visible-faces} or {@code depth-order}
     */
    static Visibility of(OwnMethods own, String topic) {
        return topic.equals(FACES) ? faces(own) : order(own);
    }

    private static Visibility faces(OwnMethods own) {
        var topic = own.in(new VisibleFacesTopic());
        VisibleFaces program = topic.method(OwnMethods.NAME).implementation();
        var answers = new Answers<SeenFaces>();
        VisibleFaces asked =
                (xyz, faces, eye, inside) -> {
                    SeenFaces seen =
                            answers.to(
                                    new Object[] {xyz, faces, eye},
                                    () ->
                                            topic.record(
                                                    program,
                                                    new Body(xyz, faces, eye, inside),
                                                    faces.length));
                    var visible = new boolean[seen.size()];
                    for (int f = 0; f < visible.length; f++) visible[f] = seen.visible(f);
                    return visible;
                };
        return Visibilities.by(asked);
    }

    private static Visibility order(OwnMethods own) {
        var topic = own.in(new DepthOrderTopic());
        DepthOrder program = topic.method(OwnMethods.NAME).implementation();
        var answers = new Answers<List<Painting.Piece>>();
        DepthOrder asked =
                (polygons, eye, out) ->
                        answers.to(
                                        new Object[] {polygons, eye},
                                        () ->
                                                topic.record(
                                                                program,
                                                                new Sight(polygons, eye),
                                                                topic.mostItems())
                                                        .pieces())
                                .forEach(piece -> out.piece(piece.polygon(), piece.corners()));
        return Visibilities.by(asked);
    }

    /**
     * Keeps what the program said last, be it a refusal: one that hangs is waited for once a view.
     * On any thread.
     *
     * @param <A> an answer
     */
    private static final class Answers<A> {
        private Object[] asked = {};
        private Supplier<A> said = () -> null;

        /**
         * @param input arrays that nobody writes into any more
         */
        synchronized A to(Object[] input, Supplier<A> program) {
            if (!Arrays.deepEquals(asked, input)) {
                said = outcome(program);
                asked = input;
            }
            return said.get();
        }

        private Supplier<A> outcome(Supplier<A> program) {
            try {
                A answer = program.get();
                return () -> answer;
            } catch (WrongLength length) {
                return refusing(OwnMethods.misshapen(length));
            } catch (IllegalArgumentException refusal) {
                return refusing(refusal);
            }
        }

        private Supplier<A> refusing(IllegalArgumentException refusal) {
            return () -> {
                throw refusal;
            };
        }
    }
}
