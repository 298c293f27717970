/**
 * Tells the window of a lab: its name, how its model and panel are made, and a card for each topic
 * that it shows.
 *
 * <p>A card has the topic's colours and what opens its inputs. Each lab keeps its own beside it;
 * {@code rasterlab.app.rooms} lists them. Start with {@link rasterlab.app.card.TopicCard}.
 */
package rasterlab.app.card;
