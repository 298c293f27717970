package rasterlab.app.mine;

import java.util.List;
import rasterlab.engine.study.ForwardingTopic;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** A topic in which the user's own method is found by its name; all else is the topic's. */
final class OwnTopic<C, I, O> extends ForwardingTopic<C, I, O> {
    private final Topic<C, I, O> topic;
    private final OwnMethods own;
    private final List<Method<C>> methods;

    /**
     * @param methods that it lists
     */
    OwnTopic(Topic<C, I, O> topic, OwnMethods own, List<Method<C>> methods) {
        super(topic);
        this.topic = topic;
        this.own = own;
        this.methods = methods;
    }

    @Override
    public List<Method<C>> methods() {
        return methods;
    }

    @Override
    public Method<C> method(String name) {
        return own.method(topic, name);
    }
}
