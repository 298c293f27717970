/**
 * The one core that times anything: lab, commands, exercises and server use it.
 *
 * <p>It knows loads by number and their times per item, nothing of topics or processes: whoever
 * measures runs a load and hands its time in. It says in which order the loads take turns and when
 * further rounds would tell no more, and what the times allow to be said. Start with {@link
 * rasterlab.engine.study.measuring.Rounds}; units are nanoseconds.
 */
package rasterlab.engine.study.measuring;
